#include "lab/explain/explain.h"

#include <iostream>

#include "commands/commands.h"
#include "commands/process.h"
#include "commands/scene_command.h"

namespace laver {

/// An unexplained difference has the exit code of one that exceeds a tolerance.
ExitCode run(const ExplainCommand& command) {
  const Scene scene = sceneOf(command.scene, command.overrides);
  const Explanation explanation = explain(scene, scene, command.vulkan);
  std::cout << describe(explanation);
  flushStandardOutput();
  return explanation.unexplained() == 0 ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace laver
