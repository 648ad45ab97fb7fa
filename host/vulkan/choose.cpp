#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "vulkan/device.h"

namespace laver {
namespace {

const char* typeName(VkPhysicalDeviceType type) {
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

int rank(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return 4;
    default:
      return 3;
  }
}

/// Why laver cannot use the device; empty if it can.
std::string rejection(VkPhysicalDevice device) {
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(device, &properties);
  if (properties.apiVersion < VK_API_VERSION_1_1) return "its Vulkan is older than 1.1";
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  if (std::none_of(families.begin(), families.end(),
                   [](const auto& f) { return (f.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0; }))
    return "it has no compute queue";
  return "";
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::vector<std::string> listDevices(const Instance& instance) {
  std::vector<std::string> lines;
  for (const VkPhysicalDevice device : instance.devices()) {
    VkPhysicalDeviceProperties p;
    vkGetPhysicalDeviceProperties(device, &p);
    const std::string why = rejection(device);
    lines.push_back(fmt::format(
        "{}: {} ({}, Vulkan {}.{}.{}){}", lines.size(), p.deviceName, typeName(p.deviceType),
        VK_API_VERSION_MAJOR(p.apiVersion), VK_API_VERSION_MINOR(p.apiVersion),
        VK_API_VERSION_PATCH(p.apiVersion), why.empty() ? "" : ": cannot be used, " + why));
  }
  return lines;
}

VkPhysicalDevice choosePhysicalDevice(const Instance& instance, const std::string& wanted) {
  const auto devices = instance.devices();
  if (devices.empty()) throw Error(ExitCode::Device, "no Vulkan device found (is a driver there?)");
  const bool isIndex = !wanted.empty() && wanted.size() < 6 &&
                       std::all_of(wanted.begin(), wanted.end(),
                                   [](unsigned char c) { return std::isdigit(c) != 0; });
  VkPhysicalDevice best = VK_NULL_HANDLE;
  int bestRank = 0;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    VkPhysicalDeviceProperties p;
    vkGetPhysicalDeviceProperties(devices[i], &p);
    bool matches = true;
    if (isIndex)
      matches = std::stoul(wanted) == i;
    else if (lower(wanted) == "cpu")
      matches = p.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    else if (!wanted.empty())
      matches = lower(p.deviceName).find(lower(wanted)) != std::string::npos;
    if (!matches || !rejection(devices[i]).empty()) continue;
    if (best == VK_NULL_HANDLE || rank(p.deviceType) < bestRank) {
      best = devices[i];
      bestRank = rank(p.deviceType);
    }
  }
  if (best != VK_NULL_HANDLE) return best;
  std::string message = wanted.empty() ? "no usable Vulkan device"
                                       : "no usable Vulkan device matches \"" + wanted + "\"";
  const char* separator = "; there are ";
  for (const auto& line : listDevices(instance)) {
    message += separator + line;
    separator = ", ";
  }
  throw Error(ExitCode::Device, message);
}

}  // namespace laver
