#pragma once
#include <volk.h>

#include <cstdint>
#include <span>
#include <string>

namespace laver {

/// Properties of a Vulkan device that is not open yet.
struct DeviceInfo {
  std::string name;
  std::string driver;  ///< name and version of the driver
  VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  std::uint32_t apiVersion = 0;
  int computeFamily = -1;           ///< first queue family with compute; -1 if there is none
  std::uint32_t subgroupSize = 0;   ///< 0 before Vulkan 1.1
  bool shuffles = false;            ///< compute shaders support subgroup shuffles
  bool longs = false;               ///< shaderInt64
  std::uint64_t maxAllocation = 0;  ///< maxMemoryAllocationSize in bytes; 0 before Vulkan 1.1
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDeviceMemoryProperties memory{};
};

DeviceInfo deviceInfo(VkPhysicalDevice device);

/// For example "discrete GPU".
std::string typeName(VkPhysicalDeviceType type);

/// For example "1.3.230".
std::string versionText(std::uint32_t version);

/// Why laver cannot use the device; empty if it can.
std::string rejection(const DeviceInfo& device);

/// The index in `devices` of the device that `wanted` selects: "cpu", an index, or a part of the
/// name, in any case; empty selects any. Of several matches the first by kind wins (discrete,
/// integrated, virtual, others, CPU); devices that cannot be used are skipped. Throws Error(Device)
/// that lists all devices and why they were rejected.
std::size_t chooseDevice(std::span<const DeviceInfo> devices, const std::string& wanted);

}  // namespace laver
