#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "image/io.h"
#include "lab/chart/chart.h"
#include "lab/chart/machine.h"
#include "lab/chart/measure.h"
#include "lab/chart/truth.h"

namespace laver::chart {
namespace {

constexpr double kRunsEnd = 0.95;

void measureAll(Chart& chart, Measurement& measurement, const Image& truth,
                const Options& options) {
  std::size_t steps = 0;
  const auto hasStep = [&](const Series& series) {
    return !stepOptions(series, steps, options.samples).empty();
  };
  while (std::any_of(chart.series.begin(), chart.series.end(), hasStep)) ++steps;
  Part part(options, kTruthEnd, kRunsEnd);
  for (std::size_t step = 0; step < steps; ++step) {
    measurement.measure(chart.series, step, truth);
    part.progress(static_cast<double>(step + 1) / static_cast<double>(steps), 0);
  }
}

std::vector<MethodPoint> methodsOf(const Scene& scene, const Options& options) {
  try {
    auto methods =
        chartMethods(scene, options.device, options.runs, [&] { return stops(options.observers); });
    throwIfStopped(options);
    return methods;
  } catch (const Error& error) {  // the scene has spheres, or its tree is too large for a buffer
    if (options.say) options.say(std::string("intersection methods are left out: ") + error.what());
    return {};
  }
}

Chart make(const Options& options) {
  Chart chart;
  chart.scene = options.scene;
  chart.machine = machine();
  chart.date = today();
  chart.width = options.size.x;
  chart.height = options.size.y;
  chart.truthSamples = options.truthSamples;
  Measurement measurement(options);
  measurement.probe(chart);
  chart.series = seriesFor(chart.traversal, options.peers);
  measurement.tryPeers(chart);
  const Scene scene = sceneOf(options);
  const Truth truth = truthOf(scene, options, measurement);
  chart.truthError = truth.error;
  chart.truthOrigin = truth.origin;
  chart.paths = scene.integrator.row->bounces;
  measureAll(chart, measurement, truth.image, options);
  chart.methods = methodsOf(scene, options);
  writeExr((std::filesystem::path(options.folder) / "reference.exr").string(), truth.image);
  return chart;
}

}  // namespace

std::optional<Chart> makeChart(const Options& options) {
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if (error)
    throw Error(ExitCode::Output, fmt::format("cannot create the folder \"{}\": {}", options.folder,
                                              error.message()));
  try {
    return make(options);
  } catch (const Stopped&) {
    return {};
  }
}

}  // namespace laver::chart
