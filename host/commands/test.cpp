#include <iostream>

#include "commands/commands.h"
#include "commands/process.h"
#include "lab/hypothesis/run.h"
#include "scene/test_file.h"

namespace laver {

ExitCode runTestFile(const RenderCommand& command) {
  TestFile file = loadTestFile(command.scene, command.overrides);
  for (const std::string& warning : file.warnings) std::cerr << warning << '\n';
  if (command.overrides.sampleCount) file.sampleCount = *command.overrides.sampleCount;
  const TestOptions options{command.vulkan, command.reference, command.options.threads};
  const TestOutcome outcome = runTests(file, options, [&](const std::string& text) {
    if (!command.quiet) std::cout << text << std::flush;
  });
  flushStandardOutput();
  return outcome.passed == outcome.tests ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace laver
