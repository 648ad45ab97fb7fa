#pragma once
#include <volk.h>

#include <cstdint>
#include <span>
#include <string>

namespace laver {

/// What a Vulkan device says about itself before it is used.
struct DeviceInfo {
  std::string name;
  std::string driver;  ///< its name and version
  VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  std::uint32_t apiVersion = 0;
  int computeFamily = -1;           ///< first queue family that computes; -1: none does
  std::uint32_t subgroupSize = 0;   ///< 0 before Vulkan 1.1
  bool shuffles = false;            ///< subgroups of compute shaders shuffle
  bool longs = false;               ///< shaders compute with 64-bit integers
  std::uint64_t maxAllocation = 0;  ///< maxMemoryAllocationSize in bytes; 0 before Vulkan 1.1
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDeviceMemoryProperties memory{};
};

DeviceInfo deviceInfo(VkPhysicalDevice device);

/// Such as "discrete GPU".
std::string typeName(VkPhysicalDeviceType type);

/// Such as "1.3.230".
std::string versionText(std::uint32_t version);

/// Why laver cannot use the device; empty if it can.
std::string rejection(const DeviceInfo& device);

/// The place in `devices` that `wanted` means: empty (discrete before integrated before virtual
/// before others before CPU), "cpu", an index, or a part of the name, case ignored; of several that
/// match, the first by kind, and those that cannot be used are passed over. Throws Error(Device)
/// that lists what there is and why it was rejected.
std::size_t chooseDevice(std::span<const DeviceInfo> devices, const std::string& wanted);

}  // namespace laver
