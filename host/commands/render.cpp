#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <span>

#include "commands/checks.h"
#include "commands/commands.h"
#include "commands/in_window.h"
#include "commands/interruption.h"
#include "commands/metadata.h"
#include "commands/progress.h"
#include "commands/resume.h"
#include "commands/standard_output.h"
#include "core/atomic_file.h"
#include "image/io.h"
#include "reference/reference.h"
#include "show/tev_client.h"

namespace laver {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// As Nori prints durations.
std::string timeText(double seconds) {
  if (seconds < 1.0) return fmt::format("{:.1f}ms", seconds * 1e3);
  if (seconds < 60.0) return fmt::format("{:.1f}s", seconds);
  if (seconds < 3600.0) return fmt::format("{:.1f}m", seconds / 60.0);
  return fmt::format("{:.1f}h", seconds / 3600.0);
}

/// Largest resident size of the process so far.
std::uint64_t peakBytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

void writeStats(const RenderCommand& command, const Stats& stats) {
  if (command.statsFile.empty()) {
    if (command.stats) std::cerr << stats.text();
    return;
  }
  const std::string text = stats.json().dump(2) + '\n';
  std::error_code error;
  const auto status = std::filesystem::status(command.statsFile, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    replaceFile(command.statsFile, std::as_bytes(std::span(text)));
    return;
  }
  std::ofstream file(command.statsFile);  // such as a pipe
  if (!(file << text).flush())
    throw Error(ExitCode::Output, command.statsFile + ": cannot be written");
}

/// Renders with `renderer`, or the reference where there is none.
Rendered render(const RenderCommand& command, const Scene& scene, Renderer* renderer,
                FilmState& state, Stats& stats, std::vector<Observer*> observers) {
  RenderOptions options = command.options;
  // Adaptive sampling leaves its map beside the picture.
  if (options.error > 0.0 && !asks(options.layers, Layer::Samples))
    options.layers.push_back(Layer::Samples);
  Progress progress(!command.quiet);
  options.observers = std::move(observers);
  options.observers.push_back(&progress);
  if (renderer != nullptr) return renderer->render(scene, options, state, stats);
  stats.device = "reference";
  stats.driver = "double precision on the CPU";
  stats.traversal = "reference";
  const auto start = Clock::now();
  const Reference reference(scene, options.threads);
  stats.seconds.build = since(start);
  Rendered rendered = reference.render(options);
  stats.droppedSamples = rendered.droppedSamples;
  stats.seconds.trace = since(start) - stats.seconds.build;
  return rendered;
}

void writePictures(const std::filesystem::path& exr, const Image& image, const Metadata& metadata,
                   unsigned threads) {
  const std::string png = std::filesystem::path(exr).replace_extension(".png").string();
  auto pngDone = std::async(std::launch::async, [&] { writePng(png, image); });
  writeExr(exr.string(), image, metadata, threads);
  pngDone.get();
}

/// Where the picture goes if the render was ended early: a.partial.exr instead of a.exr.
std::filesystem::path partial(std::filesystem::path exr) {
  return exr.replace_extension(".partial.exr");
}

Error interrupted(const std::string& what) { return {Interruption::code(), "interrupted " + what}; }

/// `viewed` may be null.
ExitCode run(const RenderCommand& command, ViewedPictures* viewed) {
  const auto start = Clock::now();
  Interruption interruption;
  if (command.resume && command.reference)
    throw Error(ExitCode::Usage, "--resume goes with Vulkan renders, not with --reference");
  std::unique_ptr<Renderer> renderer;
  if (!command.reference) {
    // lavapipe reads its thread count when it starts.
    if (command.options.threads != 0)
      ::setenv("LP_NUM_THREADS", std::to_string(command.options.threads).c_str(), 0);
    renderer = std::make_unique<Renderer>(command.vulkan);
  }

  Stats stats;
  const LoadedScene loaded = loadScene(command.scene, overridesOf(command));
  const Scene& scene = loaded.scene;
  for (const auto& warning : loaded.warnings) std::cerr << warning << '\n';
  warnOfMissingUvs(command.options, scene);
  checkOptions(command, scene);
  checkRender(command, scene.camera);
  const auto wanted = outputOf(command);
  const auto stateFile = statePath(wanted);
  if (command.resume) checkReplaceable(stateFile.string());
  stats.seconds.load = since(start);
  const char* const nothing = "before the first pass; nothing is written";
  if (Interruption::noted()) throw interrupted(nothing);

  FilmState state = stateOf(command, stateFile, scene.camera);
  std::optional<TevClient> display;
  if (command.displayServer) display.emplace(*command.displayServer, wanted.string());
  if (!command.quiet) std::cout << "Configuration: " << describe(scene) << "\nRendering .. ";
  flushStandardOutput();  // better now than after a long render
  std::optional<WindowReport> window;
  const Crop core = coreOf(scene.camera, command.options);
  if (viewed != nullptr)
    window.emplace(*viewed, wanted.string(), core.x1 - core.x0, core.y1 - core.y0);
  std::vector<Observer*> observers{&interruption};
  if (display) observers.push_back(&*display);
  if (window) observers.push_back(&*window);
  const auto renderStart = Clock::now();
  const Rendered rendered =
      render(command, scene, renderer.get(), state, stats, std::move(observers));
  const Image& image = rendered.image;
  const double renderSeconds = since(renderStart);
  if (window) window->end(image);
  const Reached& reached = rendered.reached;
  const bool whole = rendered.whole();
  if (!command.quiet)
    std::cout << fmt::format("{}. (took {})\n", whole ? "done" : "stopped",
                             timeText(renderSeconds));
  if (reached.rows == 0) throw interrupted(nothing);
  if (rendered.droppedSamples != 0)
    std::cerr << fmt::format(
        "laver: warning: {} samples were negative or not finite and are left "
        "out\n",
        rendered.droppedSamples);

  const auto writeStart = Clock::now();
  const auto exr = whole ? wanted : partial(wanted);
  if (!command.quiet)
    std::cout << fmt::format("Writing a {}x{} OpenEXR file to \"{}\"\n", image.width, image.height,
                             exr.string());
  writePictures(exr, image, metadataOf(scene, rendered, stats, renderSeconds),
                command.options.threads);
  const bool countFree = scene.sampler.row->countFree;
  const std::string goOn =
      leaveState(command, stateFile, state, !whole || (command.resume && countFree));
  stats.seconds.write = since(writeStart);
  stats.seconds.total = since(start);
  stats.peakBytes = peakBytes();
  writeStats(command, stats);
  flushStandardOutput();
  if (whole) return ExitCode::Ok;
  const std::string beside =
      reached.unfinished == 0 ? "" : fmt::format(", {} layers unfinished", reached.unfinished);
  throw interrupted(fmt::format("with {} of {} samples a pixel in {} of {} rows{}; see \"{}\"{}",
                                reached.samples, scene.sampler.sampleCount, reached.rows,
                                image.height, beside, exr.string(), goOn));
}

}  // namespace

ExitCode run(const RenderCommand& command) {
  if (!command.gui) return run(command, nullptr);
  return runInWindow(command.scene + " - laver",
                     [&](ViewedPictures& viewed) { return run(command, &viewed); });
}

}  // namespace laver
