#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/error.h"
#include "vulkan/device_info.h"

namespace laver {
namespace {

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

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isIndex(const std::string& wanted) {
  return !wanted.empty() && wanted.size() < 6 &&
         std::all_of(wanted.begin(), wanted.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool matches(const DeviceInfo& device, std::size_t index, const std::string& wanted) {
  if (wanted.empty()) return true;
  if (isIndex(wanted)) return std::stoul(wanted) == index;
  if (lower(wanted) == "cpu") return device.type == VK_PHYSICAL_DEVICE_TYPE_CPU;
  return lower(device.name).find(lower(wanted)) != std::string::npos;
}

std::string summary(const DeviceInfo& device, std::size_t index) {
  const std::string why = rejection(device);
  return fmt::format("{}: {} ({}, Vulkan {}){}", index, device.name, typeName(device.type),
                     versionText(device.apiVersion), why.empty() ? "" : ": cannot be used, " + why);
}

}  // namespace

std::size_t chooseDevice(std::span<const DeviceInfo> devices, const std::string& wanted) {
  if (devices.empty()) throw Error(ExitCode::Device, "no Vulkan device found (is a driver there?)");
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (!matches(devices[i], i, wanted) || !rejection(devices[i]).empty()) continue;
    if (!best || rank(devices[i].type) < rank(devices[*best].type)) best = i;
  }
  if (best) return *best;
  std::string message = wanted.empty() ? "no usable Vulkan device"
                                       : "no usable Vulkan device matches \"" + wanted + "\"";
  for (std::size_t i = 0; i < devices.size(); ++i)
    message += (i == 0 ? "; there are " : ", ") + summary(devices[i], i);
  throw Error(ExitCode::Device, message);
}

}  // namespace laver
