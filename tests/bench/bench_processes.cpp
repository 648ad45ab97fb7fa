#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "bench/bench.h"
#include "bench/laver_pass.h"
#include "bench/scenes.h"
#include "core/error.h"

namespace laver::bench {
namespace {

/// Seconds from the start of `laver arguments...` to its end.
double processSeconds(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), LAVER_BINARY);
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1 /* O_WRONLY */, 0);
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  int status = posix_spawn(&child, LAVER_BINARY, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (status == 0) ::waitpid(child, &status, 0);
  if (status != 0) throw Error(ExitCode::Output, "the process failed: laver " + arguments[1]);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
    if (round == 0) continue;
    start.push_back(empty);
    whole.push_back(all);
    write.push_back(seconds["write"]);
    pixels.push_back(empty + seconds["total"].get<double>() - write.back());
  }
  std::filesystem::remove_all(folder);
  report.section("Process: laver scenes/bunny-whitted.xml --spp 1, 768 x 768, warm",
                 {{"shadow rays a hit", 2}});
  report.timing("start of a process alone", start);
  report.timing("start to pixels in memory", pixels);
  report.timing("EXR and PNG", write);
  report.timing("start to end", whole);
  report.figure("process start to pixels, 768 x 768 bunny, 1 sample", median(pixels) * 1e3, "60",
                " ms");
  report.figure("EXR + PNG of 768 x 768", median(write) * 1e3, "60", " ms");
}

void manySamples(Report& report, const Rounds& rounds) {
  Scene scene = benchScene("bunny");
  scene.filter = Filter{};
  std::vector<double> speed(2);
  for (const std::size_t which : {0U, 1U}) {
    scene.sampler.sampleCount = which == 0 ? 16 : 64;
    std::vector<double> trace, reconstruct, both;
    for (std::size_t round = 0; round < (which == 0 ? rounds.renders : 1); ++round) {
      const auto seconds = renderWithLaver(scene, 2).stats.seconds;
      trace.push_back(seconds.trace);
      reconstruct.push_back(seconds.reconstruct);
      both.push_back(seconds.trace + seconds.reconstruct);
    }
    const double samples = 1280.0 * 720.0 * scene.sampler.sampleCount;
    report.section(fmt::format("Gaussian filter: bunny, {} samples, direct_whitted, 2 threads",
                               scene.sampler.sampleCount),
                   {{"rays", samples}});
    report.timing("laver trace", trace, samples);
    report.timing("laver reconstruct", reconstruct, samples);
    report.timing("laver both", both, samples);
    speed[which] = samples / median(both);
    if (which == 0)
      report.figure("reconstruction against tracing, 16 samples, gaussian",
                    median(reconstruct) / median(trace), "< 0.5");
  }
  report.figure("64 samples, trace + reconstruct, against 16 samples", speed[1] / speed[0],
                ">= 0.8");
}

}  // namespace

void benchProcesses(Report& report, const Rounds& rounds) {
  manySamples(report, rounds);
  wholeProcess(report, rounds);
}

}  // namespace laver::bench
