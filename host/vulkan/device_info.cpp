#include "vulkan/device_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "vulkan/handle.h"

namespace laver {
namespace {

int computeFamily(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i)
    if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) return static_cast<int>(i);
  return -1;
}

bool hasExtension(VkPhysicalDevice device, std::string_view name) {
  std::uint32_t count = 0;
  check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr),
        "vkEnumerateDeviceExtensionProperties");
  std::vector<VkExtensionProperties> extensions(count);
  check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data()),
        "vkEnumerateDeviceExtensionProperties");
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](const auto& e) { return name == e.extensionName; });
}

}  // namespace

DeviceInfo deviceInfo(VkPhysicalDevice device) {
  DeviceInfo info;
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(device, &properties);
  info.name = properties.deviceName;
  info.driver = fmt::format("version {:#x}", properties.driverVersion);
  info.type = properties.deviceType;
  info.apiVersion = properties.apiVersion;
  info.limits = properties.limits;
  info.computeFamily = computeFamily(device);
  vkGetPhysicalDeviceMemoryProperties(device, &info.memory);
  VkPhysicalDeviceFeatures features;
  vkGetPhysicalDeviceFeatures(device, &features);
  info.longs = features.shaderInt64 == VK_TRUE;
  if (info.apiVersion < VK_API_VERSION_1_1) return info;

  VkPhysicalDeviceMaintenance3Properties maintenance{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES};
  VkPhysicalDeviceSubgroupProperties subgroup{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES, &maintenance, 0, 0, 0, VK_FALSE};
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  const bool driverTells = info.apiVersion >= VK_API_VERSION_1_2 ||
                           hasExtension(device, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME);
  if (driverTells) maintenance.pNext = &driver;
  VkPhysicalDeviceProperties2 more{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  more.pNext = &subgroup;
  vkGetPhysicalDeviceProperties2(device, &more);
  info.subgroupSize = subgroup.subgroupSize;
  info.shuffles = (subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0 &&
                  (subgroup.supportedOperations & VK_SUBGROUP_FEATURE_SHUFFLE_BIT) != 0;
  info.maxAllocation = maintenance.maxMemoryAllocationSize;
  if (driverTells) info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
  return info;
}

std::string typeName(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "CPU";
    default:
      return "other";
  }
}

std::string versionText(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

std::string rejection(const DeviceInfo& device) {
  if (device.apiVersion < VK_API_VERSION_1_1) return "its Vulkan is older than 1.1";
  if (device.computeFamily < 0) return "it has no compute queue";
  return "";
}

}  // namespace laver
