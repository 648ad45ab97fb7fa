#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

#include "commands/commands.h"
#include "commands/process.h"
#include "core/error.h"
#include "lab/device_check.h"
#include "render/traversal.h"
#include "vulkan/instance.h"

namespace laver {
namespace {

std::string row(const char* label, const std::string& value) {
  return fmt::format("   {:<26}{}\n", label, value);
}

std::string bytes(std::uint64_t count) { return fmt::format("{} ({} MiB)", count, count >> 20); }

std::string heaps(const VkPhysicalDeviceMemoryProperties& memory) {
  std::string text;
  for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
    const bool local = (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0;
    text += fmt::format("{}{} MiB{}", i == 0 ? "" : ", ", memory.memoryHeaps[i].size >> 20,
                        local ? " device-local" : "");
  }
  return text;
}

/// Of one render of a check: most take less than a second.
constexpr double kSecondsOfACheck = 120.0;

/// Checks all devices that can be used, and prints a line for each picture.
ExitCode check(const std::vector<DeviceInfo>& devices) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  std::size_t wrong = 0, used = 0;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceInfo& device = devices[i];
    std::cout << fmt::format("{}: {}, {}\n", i, device.name, device.driver);
    if (const std::string why = rejection(device); !why.empty()) {
      std::cout << row("cannot be used", why);
      continue;
    }
    ++used;
    checkDevice(self, i, device, kSecondsOfACheck, [&](const DeviceCheck& done) {
      wrong += done.right ? 0 : 1;
      std::cout << fmt::format("   {:<18}{:<7}{:7.2f} s   {}\n", done.name,
                               done.right ? "right" : "WRONG", done.seconds, done.finding)
                << std::flush;
    });
  }
  if (used == 0) throw Error(ExitCode::Device, "no device can be used");
  std::cout << (wrong == 0 ? std::string("all pictures are right\n")
                           : fmt::format("{} pictures are wrong or missing\n", wrong));
  flushStandardOutput();
  return wrong == 0 ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace

std::string describe(const DeviceInfo& device, std::size_t index, bool isDefault) {
  const std::string why = rejection(device);
  const VkPhysicalDeviceLimits& limits = device.limits;
  std::string text = fmt::format("{}: {}{}\n", index, device.name, isDefault ? " (default)" : "");
  if (!why.empty()) text += row("cannot be used", why);
  text += row("type", typeName(device.type));
  text += row("driver", device.driver);
  text += row("Vulkan", versionText(device.apiVersion));
  if (why.empty()) {
    text += row("subgroup size", std::to_string(device.subgroupSize));
    text += row("traversal", runsPackets(device) ? "packet" : "lane");
  }
  text += row("maxStorageBufferRange", bytes(limits.maxStorageBufferRange));
  text += row("maxTexelBufferElements", std::to_string(limits.maxTexelBufferElements));
  if (device.maxAllocation != 0)
    text += row("maxMemoryAllocationSize", bytes(device.maxAllocation));
  text += row("maxComputeWorkGroupCount",
              fmt::format("{}", fmt::join(limits.maxComputeWorkGroupCount, " x ")));
  return text + row("memory heaps", heaps(device.memory));
}

ExitCode run(const DevicesCommand& command) {
  const Instance instance(false);
  std::vector<DeviceInfo> devices;
  for (const VkPhysicalDevice device : instance.devices()) devices.push_back(deviceInfo(device));
  if (command.check) return check(devices);
  const bool usable = std::any_of(devices.begin(), devices.end(),
                                  [](const DeviceInfo& d) { return rejection(d).empty(); });
  // chooseDevice() throws if there is no device at all.
  const std::size_t chosen = usable || devices.empty() ? chooseDevice(devices, "") : devices.size();
  for (std::size_t i = 0; i < devices.size(); ++i)
    std::cout << (i == 0 ? "" : "\n") << describe(devices[i], i, i == chosen);
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
