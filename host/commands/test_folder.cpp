#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <span>

#include "commands/cli.h"
#include "commands/commands.h"
#include "commands/process.h"
#include "core/atomic_file.h"
#include "lab/suite/report.h"
#include "lab/suite/run.h"
#include "vulkan/device.h"
#include "vulkan/instance.h"

namespace laver {
namespace {

/// Why no device can be used; empty if one can.
std::string deviceProblem(const std::string& wanted) {
  try {
    const Instance instance(false);
    choosePhysicalDevice(instance, wanted);
    return {};
  } catch (const Error& error) {
    return fmt::format("no Vulkan device can be used: {}", error.what());
  }
}

/// Options of every render.
std::vector<std::string> optionsOf(const TestCommand& command) {
  std::vector<std::string> options;
  if (command.reference) options.emplace_back("--reference");
  if (!command.vulkan.device.empty()) options.push_back("--device=" + command.vulkan.device);
  if (!command.vulkan.traversal.empty())
    options.push_back("--traversal=" + command.vulkan.traversal);
  if (command.threads != 0) options.push_back("--threads=" + std::to_string(command.threads));
  return options;
}

/// Throws Error(Usage) if a render does not take these options.
void checkOptions(const std::vector<std::string>& options) {
  std::vector<const char*> argv = {"laver", "scene.xml"};
  for (const std::string& option : options) argv.push_back(option.c_str());
  parse(static_cast<int>(argv.size()), argv.data());
}

void writeReport(const std::string& file, const std::string& text) {
  if (!file.empty()) replaceFile(file, std::as_bytes(std::span(text)));
}

}  // namespace

ExitCode run(const TestCommand& command) {
  const Interruption interruption;
  for (const std::string& file : {command.junit, command.html})
    if (!file.empty()) checkReplaceable(file);
  const std::vector<suite::Test> tests = suite::discover(command.folder);
  suite::Options options;
  options.self = std::filesystem::read_symlink("/proc/self/exe").string();
  options.options = optionsOf(command);
  options.check = checkOptions;
  options.jobs = command.jobs;
  options.timeout = command.timeout;
  options.accept = command.accept;
  options.pictures = !command.html.empty();
  options.stopped = Interruption::noted;
  if (!command.reference) options.skip = deviceProblem(command.vulkan.device);
  if (!options.skip.empty() && !command.allowSkip)
    throw Error(ExitCode::Device,
                options.skip + "; no test was run (--allow-skip counts tests as skipped)");

  const auto results = suite::runTests(tests, options, [](const suite::Result& result) {
    std::cout << suite::lineOf(result) << '\n';
    flushStandardOutput();
  });
  if (results.size() < tests.size())
    throw Error(Interruption::code(),
                fmt::format("interrupted after {} of {} tests; no report is written",
                            results.size(), tests.size()));
  const suite::Counts counts = suite::countsOf(results);
  std::cout << suite::summaryOf(counts) << '\n';
  flushStandardOutput();
  writeReport(command.junit, command.junit.empty() ? "" : suite::junitOf(results, command.folder));
  writeReport(command.html, command.html.empty() ? "" : suite::htmlOf(results, command.folder));
  return counts.failed == 0 ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace laver
