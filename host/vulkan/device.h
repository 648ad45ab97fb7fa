#pragma once
#include <volk.h>

#include <functional>
#include <string>
#include <vector>

#include "vulkan/handle.h"
#include "vulkan/instance.h"

namespace laver {

/// Picks by `wanted`: empty (discrete before integrated before others before CPU), "cpu", an index
/// as `laver devices` prints it, or a part of the name, case ignored. Throws Error(Device) that
/// lists what there is and why it was rejected.
VkPhysicalDevice choosePhysicalDevice(const Instance& instance, const std::string& wanted);

/// One line a device: index, name, type, driver, and why it cannot be used, if it cannot.
std::vector<std::string> listDevices(const Instance& instance);

/// A logical device with one compute queue.
class Device {
 public:
  explicit Device(VkPhysicalDevice physical);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkDevice get() const { return device_; }
  const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
  std::string name() const { return properties_.deviceName; }
  std::string driver() const { return driver_; }
  std::uint32_t subgroupSize() const { return subgroupSize_; }
  bool shufflesInCompute() const { return shuffles_; }
  std::uint64_t maxAllocation() const { return maxAllocation_; }

  /// A memory type of `bits` with all of `flags`, or -1.
  int memoryType(std::uint32_t bits, VkMemoryPropertyFlags flags) const;
  VkMemoryPropertyFlags memoryFlags(std::uint32_t type) const;

  /// Records commands, submits them and waits for their end. Not for two threads at once.
  void run(const std::function<void(VkCommandBuffer)>& record) const;

  /// Throws Error(Device) naming the limit, what was asked and what the device has.
  static void requireLimit(const char* limit, std::uint64_t wanted, std::uint64_t available);

 private:
  VkPhysicalDeviceProperties properties_{};
  VkPhysicalDeviceMemoryProperties memory_{};
  std::string driver_;
  std::uint32_t subgroupSize_ = 0;
  bool shuffles_ = false;
  std::uint64_t maxAllocation_ = 0;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  Handle<VkCommandPool> pool_;
  Handle<VkFence> fence_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

}  // namespace laver
