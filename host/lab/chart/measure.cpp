#include "lab/chart/measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/numeric.h"
#include "reference/reference.h"

namespace laver::chart {
namespace {

/// Pictures with more samples per pixel are not compared with the reference's picture of the same
/// samples, which would take longer than everything else.
constexpr double kMaxJudged = 64;
constexpr const char* kLaver = "laver";

std::vector<std::string> commandOf(const std::string& program, const std::vector<std::string>& more,
                                   const Options& options) {
  std::vector<std::string> command{options.self};
  for (const Peer& peer : options.peers)
    if (peer.name == program) command = peer.command;
  command.insert(command.end(),
                 {options.scene, "--size", fmt::format("{}x{}", options.size.x, options.size.y)});
  if (program == kLaver && !options.device.empty())
    command.insert(command.end(), {"--device", options.device});
  if (options.threads != 0)
    command.insert(command.end(), {"--threads", std::to_string(options.threads)});
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::vector<std::string> commandOf(const Series& series, std::size_t step, const Options& options) {
  return commandOf(series.program, stepOptions(series, step, options.samples), options);
}

void throwIfFailed(const Run& run, const std::string& program) {
  if (run.exitCode != 0)
    throw Error(run.exitCode <= 5 ? static_cast<ExitCode>(run.exitCode) : ExitCode::Output,
                fmt::format("{} failed: {}", program, run.lastError));
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

bool isJudged(const Series& series) {
  return series.program == "laver" && !series.adaptive &&
         series.points.back().samples <= kMaxJudged;
}

}  // namespace

void throwIfStopped(const Options& options) {
  if (stops(options.observers)) throw Stopped{};
}

Scene sceneOf(const Options& options) {
  SceneOverrides overrides;
  overrides.size = options.size;
  return loadScene(options.scene, overrides).scene;
}

void Measurement::probe(Chart& chart) const {
  const Run run = runOnce({"", "laver", samplers::independent.name, false, "", {}}, 0);
  chart.device = run.stats.value("device", "");
  chart.driver = run.stats.value("driver", "");
  chart.traversal = run.stats.value("traversal", "");
}

void Measurement::tryPeers(Chart& chart) const {
  std::erase_if(chart.series, [&](const Series& series) {
    if (series.program == "laver") return false;
    const Run run = start(series, 0);
    const bool missing = run.exitCode == kUnavailable || run.exitCode == kNotFound;
    if (missing) chart.missing.push_back(fmt::format("{}: {}", series.name, run.lastError));
    return missing;
  });
}

void Measurement::measure(std::vector<Series>& series, std::size_t step, const Image& truth) {
  std::vector<Series*> active;
  for (Series& each : series)
    if (!stepOptions(each, step, options_.samples).empty()) active.push_back(&each);
  for (Series* each : active) each->points.emplace_back();
  for (std::size_t i = 0; i <= options_.runs; ++i)
    for (Series* each : active) {
      const Run run = runOnce(*each, step);
      if (i > 0) addTimes(run, options_, each->points.back());
      if (i == options_.runs) finish(*each, step, truth);
    }
}

Image Measurement::render(const std::vector<std::string>& more) const {
  throwIfStopped(options_);
  const Run run = runner_.run(commandOf(kLaver, more, options_));
  throwIfStopped(options_);
  throwIfFailed(run, kLaver);
  return runner_.allChannels();
}

Run Measurement::start(const Series& series, std::size_t step) const {
  throwIfStopped(options_);
  Run run = runner_.run(commandOf(series, step, options_));
  throwIfStopped(options_);
  return run;
}

Run Measurement::runOnce(const Series& series, std::size_t step) const {
  Run run = start(series, step);
  throwIfFailed(run, series.program);
  if (!run.stats.is_object() || !run.stats.contains("seconds"))
    throw Error(ExitCode::Output, series.program + " left no figures in its --stats file");
  return run;
}

/// Measures the error of the picture of a point's last run.
void Measurement::finish(Series& series, std::size_t step, const Image& truth) {
  const Image image = runner_.picture();
  if (image.width != options_.size.x || image.height != options_.size.y)
    throw Error(ExitCode::Output, series.program + " left a picture of another size");
  Point& point = series.points.back();
  point.command = fmt::format("{}", fmt::join(commandOf(series, step, options_), " "));
  point.errors = errorsOf(image, truth);
  if (isJudged(series)) point.mismatches = judge(series, image);
  if (options_.say)
    options_.say(fmt::format("{}, {:.4g} spp: {:.1f} ms, RMSE {:.3g}", series.name, point.samples,
                             quantile(point.passSeconds, 0.5) * 1e3, point.errors.rmse));
}

/// Compares a picture with the reference's picture of the same samples.
Mismatches Measurement::judge(const Series& series, const Image& image) {
  const auto samples = static_cast<std::uint32_t>(series.points.back().samples);
  Scene scene = sceneOf(options_);
  scene.sampler.row = rowCalled(samplerRows(), series.sampler);
  scene.sampler.sampleCount = samples;
  const Reference reference(scene, options_.threads);
  RenderOptions render;
  render.threads = options_.threads;
  Image& picture = references_[{series.sampler, samples}];
  if (picture.pixels.empty()) picture = reference.render(render).image;
  return mismatchesOf(image, picture, scene, reference, options_.threads);
}

}  // namespace laver::chart
