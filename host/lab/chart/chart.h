#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lab/chart/errors.h"
#include "lab/chart/methods/methods.h"
#include "render/observer.h"

/// `laver chart`: speed against accuracy. Every way to render a scene runs in processes of its own,
/// its pictures are compared with a converged one in double precision, and the figures are drawn.
namespace laver::chart {

/// Another renderer: a command that takes `SCENE --size WxH --sampler NAME --spp N --threads N
/// -o FILE.exr --stats=FILE.json --quiet` as laver does, and whose exit code 69 says that it is not
/// available.
struct Peer {
  std::string name;
  std::vector<std::string> command;
};

/// More than these would be curves in a panel beside laver's.
inline constexpr std::size_t kMaxPeers = 3;

/// What to chart and how.
struct Options {
  std::string scene;   ///< file
  std::string folder;  ///< where everything goes
  glm::ivec2 size{0};  ///< pixels
  std::string device;  ///< as --device takes it
  unsigned threads = 0;
  std::size_t runs = 5;               ///< counted runs of each point
  std::uint32_t samples = 256;        ///< per pixel, at most
  std::uint32_t truthSamples = 1024;  ///< per pixel, of each half of the converged picture
  std::vector<Peer> peers;
  std::string self;                             ///< file of the program that renders: laver
  std::vector<Observer*> observers;             ///< of the share done; one of them may stop it
  std::function<void(const std::string&)> say;  ///< takes a line of text
};

/// A picture with its times and its error.
struct Point {
  double samples = 0;                               ///< per pixel, pilots too, mean over the film
  std::string command;                              ///< that renders it
  std::vector<double> passSeconds, processSeconds;  ///< of each run: trace + reconstruct, all
  Errors errors;
  std::optional<Mismatches> mismatches;  ///< where the reference rendered the same samples
};

/// The points of one way to render, by growing samples.
struct Series {
  std::string name;     ///< "sobol, adaptive"
  std::string program;  ///< "laver", or a peer's name
  std::string sampler;  ///< as --sampler takes it
  bool adaptive = false;
  std::string traversal;  ///< as --traversal takes it; empty: laver's own choice
  std::vector<Point> points;
};

/// A converged picture by the double-precision reference.
struct Truth {
  Image image;
  double error = 0;  ///< its own RMSE, estimated: half that between its two halves
};

/// All that the files say.
struct Chart {
  std::string scene, machine, device, driver, date;
  std::string traversal;  ///< laver's own choice
  int width = 0, height = 0;
  std::uint32_t truthSamples = 0;  ///< per pixel and half
  double truthError = 0;
  std::vector<Series> series;
  std::vector<std::string> missing;  ///< why a peer is not in the chart, one line each
  std::vector<MethodPoint> methods;
};

/// The ways to render a scene by laver: every sampler, adaptively where it can, and `independent`
/// by the traversals beside `chosen`, laver's own choice; then every peer, by `independent`.
std::vector<Series> seriesFor(const std::string& chosen, const std::vector<Peer>& peers);

/// The options of step 0, 1, ... of a series: each step takes four times the samples, or half the
/// error. Empty after the last step.
std::vector<std::string> stepOptions(const Series& series, std::size_t step,
                                     std::uint32_t maxSamples);

/// Throws Error. None where an observer stopped it.
std::optional<Chart> makeChart(const Options& options);

nlohmann::json jsonOf(const Chart& chart);

/// One line per point, under one line of headings.
std::string csvOf(const Chart& chart);

/// chart.svg, chart.png, chart.csv and chart.json. Throws Error(Output).
void writeChart(const Chart& chart, const std::string& folder);

}  // namespace laver::chart
