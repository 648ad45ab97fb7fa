#include <iostream>

#include "commands/commands.h"
#include "commands/process.h"
#include "commands/scene_command.h"
#include "render/scene_plan.h"
#include "vulkan/device.h"

namespace laver {

ExitCode run(const PlanCommand& command) {
  const Scene scene = sceneOf(command);
  const Instance instance(false);
  const DeviceInfo device = deviceInfo(choosePhysicalDevice(instance, command.vulkan.device));
  const ScenePlan plan = planScene(scene, command.options, command.vulkan, device);
  std::cout << (command.json ? plan.json().dump(2) + '\n' : plan.text());
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
