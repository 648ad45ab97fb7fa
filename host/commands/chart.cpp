#include "lab/chart/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <sstream>

#include "commands/commands.h"
#include "commands/observers.h"
#include "commands/process.h"
#include "commands/scene_command.h"

namespace laver {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

std::vector<chart::Peer> peersOf(const ChartCommand& command) {
  std::vector<chart::Peer> peers;
  for (std::size_t i = 0; i + 1 < command.peers.size(); i += 2) {
    const chart::Peer peer{command.peers[i], words(command.peers[i + 1])};
    const bool taken = std::any_of(peers.begin(), peers.end(), [&](const chart::Peer& other) {
      return other.name == peer.name;
    });
    if (taken || peer.name == "laver")
      throw Error(ExitCode::Usage, fmt::format("--peer {}: the name is taken", peer.name));
    if (peer.command.empty())
      throw Error(ExitCode::Usage, fmt::format("--peer {}: the command is empty", peer.name));
    peers.push_back(peer);
  }
  if (peers.size() > chart::kMaxPeers)
    throw Error(ExitCode::Usage, fmt::format("--peer: {} at most", chart::kMaxPeers));
  return peers;
}

/// 256 pixels wide, with the aspect ratio of the scene's film.
glm::ivec2 defaultSize(const Camera& camera) {
  const double height = std::round(256.0 * camera.height / camera.width);
  return {256, std::max(1, static_cast<int>(height))};
}

}  // namespace

ExitCode run(const ChartCommand& command) {
  Interruption interruption;
  Progress progress(!command.quiet);
  const Scene scene = sceneOf(command.scene);
  chart::Options options;
  options.scene = command.scene;
  options.folder =
      command.out.empty()
          ? std::filesystem::path(command.scene).replace_extension("").string() + "-chart"
          : command.out;
  options.size = command.size.value_or(defaultSize(scene.camera));
  if (options.size.x < 1 || options.size.y < 1)
    throw Error(ExitCode::Usage, "--size: expected a film of one pixel or more");
  options.device = command.device;
  options.threads = command.threads;
  options.runs = command.runs;
  options.samples = command.samples;
  options.truthSamples = command.referenceSamples;
  options.peers = peersOf(command);
  options.self = std::filesystem::read_symlink("/proc/self/exe").string();
  options.observers = {&interruption, &progress};
  options.say = [&](const std::string& line) {
    if (command.quiet) return;
    progress.wipe();
    std::cout << line << std::endl;
  };
  const auto chart = chart::makeChart(options);
  progress.wipe();
  if (!chart) throw Error(Interruption::code(), "interrupted; no chart is written");
  chart::writeChart(*chart, options.folder);
  options.say(
      fmt::format("Wrote chart.svg, chart.png, chart.csv, chart.json and reference.exr to "
                  "\"{}\"",
                  options.folder));
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
