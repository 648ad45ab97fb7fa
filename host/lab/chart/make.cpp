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

/// A part of the work, for its observers: from one share of the whole time, about, to another.
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

/// The mean of two stratified pictures of different seeds, neither of them the scene's; their
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

void addTimes(const Run& run, const Options& options, Point& point) {
  const auto& stats = run.stats;
  const auto& seconds = stats.at("seconds");
  point.samples = (stats.value("/samples/total"_json_pointer, 0.0) +
                   stats.value("/adaptive/pilotSamples"_json_pointer, 0.0)) /
                  options.size.x / options.size.y;
  point.passSeconds.push_back(seconds.value("trace", 0.0) + seconds.value("reconstruct", 0.0));
  point.processSeconds.push_back(seconds.value("process", run.seconds));
}

/// Measures a chart's series.
class Measurement {
 public:
  explicit Measurement(const Options& options) : options_(options), runner_(options.folder) {}

  /// Device, driver and laver's own choice of traversal.
  void probe(Chart& chart) const {
    const Run run = runOnce({"", "laver", kIndependent, false, "", {}}, 0);
    chart.device = run.stats.value("device", "");
    chart.driver = run.stats.value("driver", "");
    chart.traversal = run.stats.value("traversal", "");
  }

  /// Leaves out a peer that says it is not available.
  void tryPeers(Chart& chart) const {
    std::erase_if(chart.series, [&](const Series& series) {
      if (series.program == "laver") return false;
      const Run run = start(series, 0);
      const bool missing = run.exitCode == kUnavailable || run.exitCode == kNotFound;
      if (missing) chart.missing.push_back(fmt::format("{}: {}", series.name, run.lastError));
      return missing;
    });
  }

  /// The points of one step, in turns: a moment in which the machine does something else then falls
  /// on all series alike. A first run of each warms up caches.
  void measure(std::vector<Series>& series, std::size_t step, const Image& truth) const {
    std::vector<Series*> taking;
    for (Series& each : series)
      if (!stepOptions(each, step, options_.samples).empty()) taking.push_back(&each);
    for (Series* each : taking) each->points.emplace_back();
    for (std::size_t i = 0; i <= options_.runs; ++i)
      for (Series* each : taking) {
        Point& point = each->points.back();
        const Run run = runOnce(*each, step);
        if (i > 0) addTimes(run, options_, point);
        if (i < options_.runs) continue;
        const Image image = pictureOf(*each);
        point.command = lineOf(*each, step);
        point.errors = errorsOf(image, truth);
        if (isJudged(*each, point)) point.mismatches = judge(*each, image);
        say(options_,
            fmt::format("{}, {:.4g} samples: {:.1f} ms, RMSE {:.3g}", each->name, point.samples,
                        quantile(point.passSeconds, 0.5) * 1e3, point.errors.rmse));
      }
  }

 private:
  Run start(const Series& series, std::size_t step) const {
    throwIfStopped(options_);
    auto command = commandOf(series, options_);
    for (const auto& option : stepOptions(series, step, options_.samples))
      command.push_back(option);
    Run run = runner_.run(command);
    throwIfStopped(options_);
    return run;
  }

  Run runOnce(const Series& series, std::size_t step) const {
    Run run = start(series, step);
    if (run.exitCode != 0)
      throw Error(run.exitCode <= 5 ? static_cast<ExitCode>(run.exitCode) : ExitCode::Output,
                  fmt::format("{} failed: {}", series.program, run.lastError));
    if (!run.stats.is_object() || !run.stats.contains("seconds"))
      throw Error(ExitCode::Output, series.program + " left no figures in its --stats file");
    return run;
  }

  std::string lineOf(const Series& series, std::size_t step) const {
    return fmt::format("{} {}", fmt::join(commandOf(series, options_), " "),
                       fmt::join(stepOptions(series, step, options_.samples), " "));
  }

  Image pictureOf(const Series& series) const {
    Image image = runner_.picture();
    if (image.width != options_.size.x || image.height != options_.size.y)
      throw Error(ExitCode::Output, series.program + " left a picture of another size");
    return image;
  }

  static bool isJudged(const Series& series, const Point& point) {
    return series.program == "laver" && !series.adaptive && point.samples <= kMaxJudged;
  }

  /// Compares a picture with the reference's of the same samples.
  Mismatches judge(const Series& series, const Image& image) const {
    const auto samples = static_cast<std::uint32_t>(series.points.back().samples);
    Scene scene = sceneOf(options_);
    scene.sampler.row = rowCalled(samplerRows(), series.sampler);
    scene.sampler.sampleCount = samples;
    const Reference reference(scene, options_.threads);
    RenderOptions render;
    render.threads = options_.threads;
    auto& picture = references_[{series.sampler, samples}];
    if (picture.pixels.empty()) picture = reference.render(render).image;
    return mismatchesOf(image, picture, scene, reference, options_.threads);
  }

  const Options& options_;
  Runner runner_;
  mutable std::map<std::pair<std::string, std::uint32_t>, Image> references_;
};

std::vector<MethodPoint> methodsOf(const Scene& scene, const Options& options) {
  try {
    auto methods =
        chartMethods(scene, options.device, options.runs, [&] { return stops(options.observers); });
    throwIfStopped(options);
    return methods;
  } catch (const Error& error) {  // a sphere, or a tree too large for one buffer
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
