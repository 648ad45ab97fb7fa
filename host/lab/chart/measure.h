#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lab/chart/chart.h"
#include "lab/chart/run.h"

namespace laver::chart {

/// Thrown where an observer stopped the work; makeChart hands no chart back then.
struct Stopped {};
void throwIfStopped(const Options& options);

/// The scene at the chart's size.
Scene sceneOf(const Options& options);

/// Runs the programs of a chart. Every function throws Error and Stopped.
class Measurement {
 public:
  /// `options` outlive it.
  explicit Measurement(const Options& options) : options_(options), runner_(options.folder) {}

  /// One render by laver: finds the device, its driver and the traversal that laver chooses.
  void probe(Chart& chart) const;

  /// Leaves out a peer that says it is not available.
  void tryPeers(Chart& chart) const;

  /// Adds the point of one step to each series that has it. They take turns: a moment in which the
  /// machine does something else then falls on all alike. A first run of each warms up caches.
  void measure(std::vector<Series>& series, std::size_t step, const Image& truth);

 private:
  Run start(const Series& series, std::size_t step) const;
  Run runOnce(const Series& series, std::size_t step) const;
  void finish(Series& series, std::size_t step, const Image& truth);
  Mismatches judge(const Series& series, const Image& image);

  const Options& options_;
  Runner runner_;
  /// The reference's pictures by sampler and samples per pixel.
  std::map<std::pair<std::string, std::uint32_t>, Image> references_;
};

}  // namespace laver::chart
