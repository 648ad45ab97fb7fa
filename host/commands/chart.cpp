#include "lab/chart/chart.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "commands/commands.h"
#include "commands/interruption.h"
#include "commands/progress.h"
#include "commands/standard_output.h"
#include "image/io.h"
#include "lab/chart/panel.h"

namespace laver {
namespace {

double secondsOf(const std::string& text) {
  double seconds = 0.0;
  std::size_t used = 0;
  try {
    seconds = std::stod(text, &used);
  } catch (const std::exception&) {
  }
  if (used != text.size() || !std::isfinite(seconds) || !(seconds > 0.0))
    throw Error(ExitCode::Usage, "--peer: expected seconds above 0, not " + text);
  return seconds;
}

/// Checked before hours of rendering.
std::vector<chart::Peer> peersOf(const ChartCommand& command, glm::ivec2 size) {
  std::vector<chart::Peer> peers;
  for (std::size_t i = 0; i + 2 < command.peers.size(); i += 3) {
    const chart::Peer peer{command.peers[i], secondsOf(command.peers[i + 1]), command.peers[i + 2]};
    const Image image = chart::rgbOf(readExr(peer.file), peer.file);
    if (image.width != size.x || image.height != size.y)
      throw Error(ExitCode::Usage,
                  fmt::format("--peer {}: \"{}\" has {}x{} pixels, the chart {}x{}", peer.name,
                              peer.file, image.width, image.height, size.x, size.y));
    peers.push_back(peer);
  }
  return peers;
}

std::vector<chart::Program> programsOf(const ChartCommand& command) {
  std::vector<chart::Program> programs;
  for (std::size_t i = 0; i + 1 < command.programs.size(); i += 2) {
    chart::Program program{command.programs[i], command.programs[i + 1]};
    if (program.name == "laver" ||
        std::any_of(programs.begin(), programs.end(),
                    [&](const auto& p) { return p.name == program.name; }))
      throw Error(ExitCode::Usage, "--program " + program.name + ": the name is taken");
    if (::access(program.file.c_str(), X_OK) != 0)
      throw Error(ExitCode::Usage,
                  fmt::format("--program {}: \"{}\" cannot be run", program.name, program.file));
    programs.push_back(std::move(program));
  }
  return programs;
}

}  // namespace

ExitCode run(const ChartCommand& command) {
  const Interruption interruption;
  const LoadedScene loaded = loadScene(command.scene);
  for (const auto& warning : loaded.warnings) std::cerr << warning << '\n';
  chart::Options options;
  options.scene = command.scene;
  options.folder =
      command.out.empty()
          ? std::filesystem::path(command.scene).replace_extension("").string() + "-chart"
          : command.out;
  const Camera& camera = loaded.scene.camera;
  options.size = command.size.value_or(glm::ivec2(
      256, std::max(1, static_cast<int>(std::lround(256.0 * camera.height / camera.width)))));
  if (options.size.x < 1 || options.size.y < 1)
    throw Error(ExitCode::Usage, "--size: expected a film of one pixel or more");
  options.device = command.device;
  options.threads = command.threads;
  options.metric = command.metric;
  options.runs = command.runs;
  options.samples = command.samples;
  options.truthSamples = command.referenceSamples;
  options.peers = peersOf(command, options.size);
  options.programs = programsOf(command);
  options.self = std::filesystem::read_symlink("/proc/self/exe").string();
  options.stop = Interruption::noted;
  Progress progress(!command.quiet);
  options.progress = [&](double share) { progress.show(share); };
  options.say = [&](const std::string& line) {
    if (command.quiet) return;
    progress.wipe();
    std::cout << line << std::endl;
  };
  const auto chart = chart::makeChart(options);
  progress.wipe();
  if (!chart)
    throw Error(
        Interruption::code(),
        fmt::format("interrupted; what is done is kept in \"{}/kept\", and the same command "
                    "goes on from there",
                    options.folder));
  chart::writeChart(*chart, options);
  if (!command.quiet)
    std::cout << fmt::format("Wrote chart.html, chart.png, chart.csv and chart.json to \"{}\"\n",
                             options.folder);
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
