#include <iostream>

#include "commands/commands.h"
#include "commands/standard_output.h"
#include "render/scene_plan.h"
#include "vulkan/device.h"

namespace laver {

ExitCode run(const PlanCommand& command) {
  const LoadedScene loaded = loadScene(command.scene, overridesOf(command));
  for (const auto& warning : loaded.warnings) std::cerr << warning << '\n';
  checkOptions(command, loaded.scene);
  const Instance instance(false);
  const DeviceInfo device = deviceInfo(choosePhysicalDevice(instance, command.vulkan.device));
  const ScenePlan plan = planScene(loaded.scene, command.options, command.vulkan, device);
  std::cout << (command.json ? plan.json().dump(2) + '\n' : plan.text());
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
