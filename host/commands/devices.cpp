#include <iostream>

#include "commands/commands.h"
#include "vulkan/device.h"

namespace laver {

ExitCode runDevices() {
  const Instance instance(false);
  const auto lines = listDevices(instance);
  if (lines.empty()) throw Error(ExitCode::Device, "no Vulkan device found (is a driver there?)");
  for (const auto& line : lines) std::cout << line << '\n';
  if (!std::cout.flush()) throw Error(ExitCode::Output, "standard output cannot be written");
  return ExitCode::Ok;
}

}  // namespace laver
