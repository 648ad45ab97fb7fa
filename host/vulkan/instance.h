#pragma once
#include <volk.h>

#include <memory>
#include <string>
#include <vector>

namespace laver {

/// A VkInstance of Vulkan 1.1. With `validate`, it collects the messages of the Khronos validation
/// layer.
class Instance {
 public:
  /// Throws Error(Device) if there is no loader, no driver, or with `validate` no validation layer.
  explicit Instance(bool validate);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance get() const { return instance_; }
  std::vector<VkPhysicalDevice> devices() const;

  /// Throws Error(Device) with the first validation message, if there was one.
  void throwIfInvalid() const;

 private:
  struct Messages;
  std::unique_ptr<Messages> messages_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace laver
