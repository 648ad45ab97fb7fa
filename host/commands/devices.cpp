#include <algorithm>
#include <iostream>
#include <vector>

#include "commands/commands.h"
#include "commands/device_text.h"
#include "commands/standard_output.h"
#include "vulkan/instance.h"

namespace laver {

ExitCode runDevices() {
  const Instance instance(false);
  std::vector<DeviceInfo> devices;
  for (const VkPhysicalDevice device : instance.devices()) devices.push_back(deviceInfo(device));
  const bool usable = std::any_of(devices.begin(), devices.end(),
                                  [](const DeviceInfo& d) { return rejection(d).empty(); });
  // Where there is no device at all, chooseDevice says so.
  const std::size_t chosen = usable || devices.empty() ? chooseDevice(devices, "") : devices.size();
  for (std::size_t i = 0; i < devices.size(); ++i)
    std::cout << (i == 0 ? "" : "\n") << describe(devices[i], i, i == chosen);
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
