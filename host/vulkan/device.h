#pragma once
#include <volk.h>

#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "vulkan/device_info.h"
#include "vulkan/handle.h"
#include "vulkan/instance.h"
#include "vulkan/pipeline_cache.h"

namespace laver {

/// The physical device that matches `wanted`, by the rules of chooseDevice(). Throws Error(Device).
VkPhysicalDevice choosePhysicalDevice(const Instance& instance, const std::string& wanted);

/// A logical device with one compute queue.
class Device {
 public:
  explicit Device(VkPhysicalDevice physical);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkDevice get() const { return device_; }
  const DeviceInfo& info() const { return info_; }
  const VkPhysicalDeviceLimits& limits() const { return info_.limits; }
  const std::string& name() const { return info_.name; }
  const std::string& driver() const { return info_.driver; }
  VkPipelineCache pipelineCache() const { return cache_->get(); }
  std::uint64_t maxAllocation() const { return info_.maxAllocation; }

  /// A memory type of `bits` with all of `flags`, or -1.
  int memoryType(std::uint32_t bits, VkMemoryPropertyFlags flags) const;
  VkMemoryPropertyFlags memoryFlags(std::uint32_t type) const;

  /// Records commands, submits them and waits until they are complete. Threads wait for each other.
  void run(const std::function<void(VkCommandBuffer)>& record) const;

  /// Throws Error(Device) with the limit's name and both values if `wanted` exceeds `available`.
  static void requireLimit(const char* limit, std::uint64_t wanted, std::uint64_t available);

 private:
  DeviceInfo info_;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  Handle<VkCommandPool> pool_;
  Handle<VkFence> fence_;
  std::optional<PipelineCache> cache_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  mutable std::mutex running_;
};

}  // namespace laver
