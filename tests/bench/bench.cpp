// laver beside Embree 3, in one run: bench [--quick] [passes|rays|builds|files|processes] [OUT.json]
#include "bench/bench.h"

#include <fmt/format.h>

#include <iostream>

#include "core/error.h"

namespace laver::bench {

EmbreeScenes::EmbreeScenes(const EmbreeDevices& devices, const Scene& scene)
    : mesh(scene),
      robust(devices.native, mesh, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM),
      plain(devices.native, mesh, RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_MEDIUM),
      robustAvx2(devices.avx2, mesh, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM),
      plainAvx2(devices.avx2, mesh, RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_MEDIUM),
      robustHigh(devices.native, mesh, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_HIGH) {}

namespace {

void run(int argc, char** argv) {
  Rounds rounds;
  std::string part, file;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick")
      rounds = {3, 1, 1, 1, 1};
    else if (argument.ends_with(".json"))
      file = argument;
    else
      part = argument;
  }
  const auto wanted = [&](const char* name) { return part.empty() || part == name; };
  Report report;
  const EmbreeDevices devices;
  report.section("Embree", {{"native", devices.native.description()},
                            {"isa=avx2", devices.avx2.description()}});
  fmt::print("  medians [quartiles]; xN: N times laver's median\n");
  if (wanted("passes")) benchPasses(report, devices, rounds);
  if (wanted("rays")) benchRays(report, devices, rounds);
  if (wanted("builds")) benchBuilds(report, devices, rounds);
  if (wanted("files")) benchFiles(report, rounds);
  if (wanted("processes")) benchProcesses(report, rounds);
  report.printFigures();
  if (!file.empty()) report.save(file);
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
