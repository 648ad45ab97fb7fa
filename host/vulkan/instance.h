#pragma once
#include <volk.h>

#include <memory>
#include <string>
#include <vector>

namespace laver {

/// A VkInstance of Vulkan 1.1. With `validate`, the Khronos layer's messages are kept.
class Instance {
 public:
  /// Throws Error(Device) without a loader or a driver, or without the layer that is asked for.
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
