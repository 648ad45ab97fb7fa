#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lab/chart/errors.h"
#include "lab/chart/methods/methods.h"
#include "render/observer.h"

/// `laver chart`: speed against accuracy. Every way to render a scene runs in its own processes;
/// its pictures are compared with a converged double-precision picture, and the results are drawn.
namespace laver::chart {

/// Another renderer: a command that takes the same options as laver, `SCENE --size WxH --sampler
/// NAME --spp N --threads N -o FILE.exr --stats=FILE.json --quiet`, and exits with code 69 if it is
/// not available.
struct Peer {
  std::string name;
  std::vector<std::string> command;
};

/// Limit that keeps a panel readable beside laver's curves.
inline constexpr std::size_t kMaxPeers = 3;

/// Options of a chart.
struct Options {
  std::string scene;   ///< file
  std::string folder;  ///< for all output
  glm::ivec2 size{0};  ///< pixels
  std::string device;  ///< value of --device
  unsigned threads = 0;
  std::size_t runs = 5;               ///< timed runs per point
  std::uint32_t samples = 256;        ///< maximum per pixel
  std::uint32_t truthSamples = 1024;  ///< per pixel, of each half of the converged picture
  std::vector<Peer> peers;
  std::string self;                             ///< path of the laver program
  std::vector<Observer*> observers;             ///< of the progress; each may stop the work
  std::function<void(const std::string&)> say;  ///< prints a line of text
};

/// One configuration: times and error of its picture.
struct Point {
  double samples = 0;                  ///< per pixel, mean over the film, pilot samples included
  std::string command;                 ///< command line that renders it
  std::vector<double> passSeconds;     ///< trace + reconstruct, of each run
  std::vector<double> processSeconds;  ///< whole process, of each run
  Errors errors;
  std::optional<Mismatches> mismatches;  ///< if the reference rendered the same samples
};

/// A curve of the chart: points of one sampler and program, with growing numbers of samples.
struct Series {
  std::string name;     ///< "sobol, adaptive"
  std::string program;  ///< "laver", or a peer's name
  std::string sampler;  ///< value of --sampler
  bool adaptive = false;
  std::string traversal;  ///< value of --traversal; empty: laver's choice
  std::vector<Point> points;
};

/// The content of the chart's files.
struct Chart {
  std::string scene, machine, device, driver, date;
  std::string traversal;  ///< laver's choice
  int width = 0, height = 0;
  std::uint32_t truthSamples = 0;  ///< per pixel and half
  double truthError = 0;
  std::string truthOrigin;  ///< what made the converged picture, and how it was tested
  bool paths = false;       ///< the integrator follows paths
  std::vector<Series> series;
  std::vector<std::string> missing;  ///< one line per missing peer, with the reason
  std::vector<MethodPoint> methods;
};

/// The series of a chart: every sampler of laver, also adaptively where it can; `independent` by
/// every traversal except `chosen`, laver's choice; every peer with `independent`.
std::vector<Series> seriesFor(const std::string& chosen, const std::vector<Peer>& peers);

/// The options of step 0, 1, ... of a series. Each step takes four times the samples, or half the
/// error, of the last. Empty after the last step.
std::vector<std::string> stepOptions(const Series& series, std::size_t step,
                                     std::uint32_t maxSamples);

/// Measures everything. None if an observer stopped it. Throws Error.
std::optional<Chart> makeChart(const Options& options);

nlohmann::json jsonOf(const Chart& chart);

/// A line of headings, then one line per point.
std::string csvOf(const Chart& chart);

/// Writes chart.svg, chart.png, chart.csv and chart.json. Throws Error(Output).
void writeChart(const Chart& chart, const std::string& folder);

}  // namespace laver::chart
