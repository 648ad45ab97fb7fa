// The speed of laver, and of Embree 3 for the same rays and meshes:
// laver_bench [--short] [--markdown FILE] [--json FILE] [passes|rays|builds|files|processes]
#include "bench/bench.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "core/error.h"
#include "lab/chart/machine.h"
#include "vulkan/device.h"
#include "vulkan/instance.h"

namespace laver::bench {
namespace {

nlohmann::json about(const EmbreeDevices& devices) {
  const Instance instance(false);
  const DeviceInfo device = deviceInfo(choosePhysicalDevice(instance, "cpu"));
  return {{"date", chart::today()},
          {"machine", chart::machine()},
          {"compiler", chart::compiler()},
          {"laver", LAVER_VERSION},
          {"Vulkan device", device.name + ", " + device.driver},
          {"Embree", devices.native.description()},
          {"Embree, avx2", devices.avx2.description()}};
}

void run(int argc, char** argv) {
  CLI::App app("Measures laver, and Embree for the same rays and meshes");
  bool brief = false;
  std::string part, json, markdown;
  app.add_flag("--short", brief, "few rounds, small meshes: to try the bench out");
  app.add_option("--json", json, "file for every single time");
  app.add_option("--markdown", markdown, "file whose tables are replaced");
  app.add_option("part", part)
      ->check(CLI::IsMember({"passes", "rays", "builds", "files", "processes"}));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  const Rounds rounds = brief ? Rounds{1, 1, 1, 1, 1, true} : Rounds{};
  const auto wanted = [&](const char* name) { return part.empty() || part == name; };
  const EmbreeDevices devices;
  Report report(about(devices));
  if (wanted("passes")) benchPasses(report, rounds);
  if (wanted("rays")) benchRays(report, devices, rounds);
  if (wanted("builds")) benchBuilds(report, devices, rounds);
  if (wanted("files")) benchFiles(report, rounds);
  if (wanted("processes")) benchProcesses(report, rounds);
  report.printSummary();
  if (!json.empty()) report.saveJson(json);
  if (!markdown.empty()) report.saveMarkdown(markdown);
}

}  // namespace
}  // namespace laver::bench

int main(int argc, char** argv) {
  try {
    laver::bench::run(argc, argv);
    return 0;
  } catch (const laver::Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(laver::ExitCode::Output);
  }
}
