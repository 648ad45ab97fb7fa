#pragma once
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lab/chart/chart.h"
#include "lab/chart/run.h"

namespace laver::chart {

/// Thrown when an observer has stopped the work; makeChart() then returns nothing.
struct Stopped {};
void throwIfStopped(const Options& options);

/// The scene at the chart's size.
Scene sceneOf(const Options& options);

/// Reports one part of the work to the observers: progress from share `from` to `to` of the whole.
class Part : public Observer {
 public:
  Part(const Options& options, double from, double to)
      : observers_(options.observers), from_(from), to_(to) {}
  bool stop() override { return stops(observers_); }
  void progress(double share, std::uint64_t samples) override {
    for (Observer* observer : observers_) observer->progress(std::lerp(from_, to_, share), samples);
  }

 private:
  const std::vector<Observer*>& observers_;
  double from_, to_;
};

/// Runs the programs of a chart. Every function throws Error and Stopped.
class Measurement {
 public:
  /// `options` must outlive this object.
  explicit Measurement(const Options& options) : options_(options), runner_(options.folder) {}

  /// Renders once with laver to find the device, its driver and the traversal that laver chooses.
  void probe(Chart& chart) const;

  /// Removes peers that report that they are not available.
  void tryPeers(Chart& chart) const;

  /// All channels of laver's picture with more options.
  Image render(const std::vector<std::string>& more) const;

  /// Adds the point of one step to each series that has such a step. The series' runs alternate, so
  /// that a disturbance of the machine affects all alike. A first, untimed run of each warms up
  /// caches.
  void measure(std::vector<Series>& series, std::size_t step, const Image& truth);

 private:
  Run start(const Series& series, std::size_t step) const;
  Run runOnce(const Series& series, std::size_t step) const;
  void finish(Series& series, std::size_t step, const Image& truth);
  Mismatches judge(const Series& series, const Image& image);

  const Options& options_;
  Runner runner_;
  /// The reference's pictures, by sampler and samples per pixel.
  std::map<std::pair<std::string, std::uint32_t>, Image> references_;
};

}  // namespace laver::chart
