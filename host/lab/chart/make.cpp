#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "image/io.h"
#include "lab/chart/chart.h"
#include "lab/chart/machine.h"
#include "lab/chart/measure.h"
#include "reference/reference.h"

namespace laver::chart {
namespace {

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
constexpr double kTruthEnd = 0.4, kRunsEnd = 0.95;

Image renderReference(const Scene& scene, const Options& options, Part part) {
  RenderOptions render;
  render.threads = options.threads;
  render.observers = {&part};
  Image image = Reference(scene, options.threads).render(render).image;
  throwIfStopped(options);
  return image;
}

/// The mean of two stratified pictures with different seeds, neither of which is the scene's. Their
/// difference estimates the error of the mean.
Truth truthOf(Scene scene, const Options& options) {
  scene.sampler.row = &samplers::stratified;
  scene.sampler.sampleCount = options.truthSamples;
  scene.sampler.seed += 1;
  const Image a = renderReference(scene, options, {options, 0.0, kTruthEnd / 2});
  scene.sampler.seed += 1;
  const Image b = renderReference(scene, options, {options, kTruthEnd / 2, kTruthEnd});
  Truth truth{a, errorsOf(a, b).rmse / 2.0};
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    truth.image.pixels[i] = 0.5F * (a.pixels[i] + b.pixels[i]);
  return truth;
}

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
  const Truth truth = truthOf(scene, options);
  chart.truthError = truth.error;
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
    throw Error(ExitCode::Output,
                fmt::format("cannot make the folder \"{}\": {}", options.folder, error.message()));
  try {
    return make(options);
  } catch (const Stopped&) {
    return {};
  }
}

}  // namespace laver::chart
