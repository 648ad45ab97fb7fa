#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "bench/bench.h"
#include "bench/laver_pass.h"
#include "bench/scenes.h"
#include "core/error.h"
#include "lab/process.h"

namespace laver::bench {
namespace {

double processSeconds(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), LAVER_BINARY);
  const ProcessRun run = runProcess(arguments);
  if (run.exitCode != 0) throw Error(ExitCode::Output, "laver failed: " + run.errorOutput);
  return run.seconds;
}

void wholeProcess(Report& report, const Rounds& rounds) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("laver-bench-{}", getpid());
  std::filesystem::create_directory(folder);
  const std::string exr = (folder / "bunny.exr").string(), json = (folder / "stats.json").string();
  const std::vector<std::string> render{sceneFile("scenes/bunny-whitted.xml"),
                                        "--device",
                                        "cpu",
                                        "--spp",
                                        "1",
                                        "-o",
                                        exr,
                                        "--stats=" + json,
                                        "--quiet"};
  std::vector<double> start, whole, pixels, write;
  for (std::size_t round = 0; round <= rounds.processes; ++round) {
    const double empty = processSeconds({"--version"}), all = processSeconds(render);
    const auto seconds = nlohmann::json::parse(std::ifstream(json))["seconds"];
    if (round == 0) continue;  // may compile kernels
    start.push_back(empty);
    whole.push_back(all);
    write.push_back(seconds["write"]);
    pixels.push_back(empty + seconds["total"].get<double>() - write.back());
  }
  const auto bytes = std::filesystem::file_size(LAVER_BINARY);
  std::filesystem::remove_all(folder);
  report.section("Process: laver scenes/bunny-whitted.xml --spp 1, 768 x 768 pixels",
                 {{"size of the program, MB", 1e-6 * static_cast<double>(bytes)}});
  report.timing("start of a process alone", start);
  report.timing("start to pixels in memory", pixels);
  report.timing("write EXR and PNG", write);
  report.timing("start to end", whole);
  report.figure("bunny-whitted, 1 sample, process start to pixels in memory", median(pixels) * 1e3,
                " ms");
  report.figure("bunny-whitted, 1 sample, process start to end", median(whole) * 1e3, " ms");
}

void manySamples(Report& report, const Rounds& rounds) {
  for (const std::uint32_t samples : {16U, 64U}) {
    if (rounds.brief && samples > 16) continue;
    Scene scene = benchScene("bunny", 0, "direct_whitted", samples);
    scene.filter = Filter{};
    std::vector<double> trace, reconstruct;
    for (std::size_t round = 0; round <= rounds.renders; ++round) {
      const auto seconds = renderWithLaver(scene, 2).seconds;
      if (round == 0) continue;
      trace.push_back(seconds.trace);
      reconstruct.push_back(seconds.reconstruct);
    }
    const double rays = 1.0 * scene.camera.width * scene.camera.height * samples;
    report.section(fmt::format("Gaussian filter: bunny, direct_whitted, {}, 2 threads",
                               counted(samples, "sample")),
                   {{"camera rays", rays}});
    report.timing("trace", trace, rays);
    report.timing("reconstruct", reconstruct, rays);
    report.figure(
        fmt::format("Gaussian filter, {}: reconstruct / trace", counted(samples, "sample")),
        median(reconstruct) / median(trace), "");
  }
}

}  // namespace

void benchProcesses(Report& report, const Rounds& rounds) {
  manySamples(report, rounds);
  wholeProcess(report, rounds);
}

}  // namespace laver::bench
