#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/chart/choices.h"
#include "lab/chart/errors.h"
#include "lab/chart/methods/methods.h"
#include "lab/chart/truth.h"

namespace laver::chart {

/// A renderer that only left a picture and a time.
struct Peer {
  std::string name;
  double seconds = 0;
  std::string file;
};

/// What to chart and how.
struct Options {
  std::string scene;   ///< file
  std::string folder;  ///< where everything goes
  glm::ivec2 size{0};  ///< pixels
  std::string device;  ///< as --device takes it
  unsigned threads = 0;
  std::string metric = "rmse";  ///< of chart.png, and what the page shows first: see kMetrics
  std::size_t runs = 5;         ///< of each point, one more warms up
  std::uint32_t samples = 256;  ///< a pixel, at most
  std::uint32_t truthSamples = 1024;
  std::vector<Program> programs;
  std::vector<Peer> peers;
  std::string self;  ///< file of the program that renders: laver
  std::function<bool()> stop;
  std::function<void(double)> progress;         ///< share done
  std::function<void(const std::string&)> say;  ///< a line
};

/// A picture with its time and its error.
struct Point {
  std::string series;
  const FilterRow* filter;
  std::string program;  ///< "laver", or a peer's name
  std::string sampler;
  bool adaptive = false;
  std::string traversal;  ///< only where it is not the device's own choice
  double samples = 0;     ///< a pixel, pilots too, the mean over the film; 0: not known
  std::string command;    ///< that renders it; empty where not known
  std::vector<double> passSeconds, processSeconds;  ///< trace + reconstruct, whole process: a run
  Errors errors;
  std::optional<Mismatches> mismatches;
  std::string thumbnail, errorMap;  ///< data URIs
};

/// All that the files say.
struct Chart {
  std::string scene, machine, device, driver, date;
  int width = 0, height = 0;
  std::uint32_t truthSamples = 0;  ///< a pixel and half
  std::vector<Filter> filters;     ///< the scene's own first
  std::vector<Truth> truths;       ///< of each filter
  double floatFloor = 0;           ///< median RMSE of pictures from those of the same samples
  std::vector<Point> points;
  std::vector<MethodPoint> methods;  ///< panel C
};

/// Makes what is not kept in the folder. Throws Error; Error(Interrupted) is the caller's: where
/// options.stop ended it, none comes back.
std::optional<Chart> makeChart(const Options& options);

/// chart.json, chart.csv, chart.html and chart.png. Throws Error(Output).
void writeChart(const Chart& chart, const Options& options);

}  // namespace laver::chart
