#pragma once
#include <volk.h>

#include <string>
#include <utility>

#include "core/error.h"

namespace laver {

/// Name of a VkResult, such as VK_ERROR_DEVICE_LOST.
std::string resultName(VkResult result);

/// Throws Error(Device) "CALL: NAME" unless `result` is VK_SUCCESS.
inline void check(VkResult result, const char* call) {
  if (result != VK_SUCCESS)
    throw Error(ExitCode::Device, std::string(call) + ": " + resultName(result));
}

/// Owns a child object of a VkDevice.
template <class T>
class Handle {
 public:
  using Destroy = void(VKAPI_PTR*)(VkDevice, T, const VkAllocationCallbacks*);

  Handle() = default;
  Handle(VkDevice device, T handle, Destroy destroy)
      : device_(device), handle_(handle), destroy_(destroy) {}
  Handle(Handle&& other) noexcept { swap(other); }
  Handle& operator=(Handle&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Handle() {
    if (handle_ != VK_NULL_HANDLE) destroy_(device_, handle_, nullptr);
  }

  T get() const { return handle_; }

 private:
  void swap(Handle& other) {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
  }

  VkDevice device_ = VK_NULL_HANDLE;
  T handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

}  // namespace laver
