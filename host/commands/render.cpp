#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands/commands.h"
#include "commands/observers.h"
#include "commands/output.h"
#include "commands/parts.h"
#include "commands/process.h"
#include "commands/resume.h"
#include "commands/scene_command.h"
#include "reference/reference.h"
#include "scene/test_file.h"
#include "show/tev_client.h"

namespace laver {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Formats a duration as Nori does.
std::string timeText(double seconds) {
  if (seconds < 1.0) return fmt::format("{:.1f}ms", seconds * 1e3);
  if (seconds < 60.0) return fmt::format("{:.1f}s", seconds);
  if (seconds < 3600.0) return fmt::format("{:.1f}m", seconds / 60.0);
  return fmt::format("{:.1f}h", seconds / 3600.0);
}

/// The result of a render.
struct Ended {
  Rendered rendered;
  FilmState state;
  Stats stats;
  double seconds = 0.0;
};

/// Starts the device, which continues while the scene is loaded. Null for the reference.
std::unique_ptr<Renderer> startRenderer(const RenderCommand& command) {
  if (command.resume && command.reference)
    throw Error(ExitCode::Usage, "--resume goes with Vulkan renders, not with --reference");
  if (command.reference) return nullptr;
  // lavapipe reads its thread count when it starts.
  if (command.options.threads != 0)
    ::setenv("LP_NUM_THREADS", std::to_string(command.options.threads).c_str(), 0);
  return std::make_unique<Renderer>(command.vulkan);
}

/// The tev client and the window that the command requests; no window if `viewed` is null.
std::vector<std::unique_ptr<Observer>> viewersOf(const RenderCommand& command, const Scene& scene,
                                                 const std::string& name, ViewedPictures* viewed) {
  std::vector<std::unique_ptr<Observer>> viewers;
  if (command.displayServer)
    viewers.push_back(std::make_unique<TevClient>(*command.displayServer, name));
  const Crop core = coreOf(scene.camera, command.options);
  if (viewed != nullptr)
    viewers.push_back(std::make_unique<WindowReport>(*viewed, name, core.x1 - core.x0,
                                                     rowsOf(stripsOf(scene, command.options))));
  return viewers;
}

/// The command's render options with observers. Adaptive sampling always adds the layer of sample
/// counts.
RenderOptions optionsOf(const RenderCommand& command, std::vector<Observer*> observers,
                        const std::vector<std::unique_ptr<Observer>>& viewers) {
  RenderOptions options = command.options;
  if (options.error > 0.0 && !asks(options.layers, layers::samples))
    options.layers.push_back(&layers::samples);
  options.observers = std::move(observers);
  for (const auto& viewer : viewers) options.observers.push_back(viewer.get());
  return options;
}

/// Renders with `renderer`, or with the reference if it is null; continues from the sums in
/// `state`.
Ended renderWith(Renderer* renderer, const Scene& scene, const RenderOptions& options,
                 FilmState state) {
  Ended ended{{}, std::move(state), {}};
  const auto start = Clock::now();
  if (renderer != nullptr) {
    ended.rendered = renderer->render(scene, options, ended.state, ended.stats);
  } else {
    ended.stats.device = "reference";
    ended.stats.driver = "double precision on the CPU";
    ended.stats.traversal = "reference";
    const Reference reference(scene, options.threads);
    ended.stats.seconds.build = since(start);
    ended.rendered = reference.render(options);
    ended.stats.droppedSamples = ended.rendered.droppedSamples;
    ended.stats.seconds.trace = since(start) - ended.stats.seconds.build;
  }
  ended.seconds = since(start);
  const Crop core = coreOf(scene.camera, options);
  if (options.shard) return ended;  // its rows are no window of the film
  ended.rendered.image.window = {core.x0, core.y0, scene.camera.width, scene.camera.height};
  return ended;
}

const char* const kNothing = "before the first pass; nothing is written";

Error interrupted(const std::string& what) { return {Interruption::code(), "interrupted " + what}; }

/// The file of the picture: a.exr, or a.partial.exr if the render was stopped early.
std::filesystem::path fileOf(const Rendered& rendered, std::filesystem::path exr) {
  return rendered.whole() ? exr : exr.replace_extension(".partial.exr");
}

/// Writes the picture and the sums. Returns a text about the sums, for the message of an
/// interruption.
std::string write(const RenderCommand& command, const Scene& scene,
                  const std::filesystem::path& wanted, const Ended& ended) {
  const Rendered& rendered = ended.rendered;
  const auto exr = fileOf(rendered, wanted);
  const Metadata metadata = metadataOf(scene, rendered, ended.stats, ended.seconds);
  print(command, fmt::format("Writing a {}x{} OpenEXR file to \"{}\"\n", rendered.image.width,
                             rendered.image.height, exr.string()));
  if (command.options.shard)
    writePart(exr, command, scene, rendered, ended.state.settings, metadata);
  else
    writePictures(exr, rendered.image, metadata, command.options.threads);
  const bool countFree = scene.sampler.row->countFree;
  return leaveState(command, statePath(wanted), ended.state,
                    !rendered.whole() || (command.resume && countFree));
}

/// Describes how much of an interrupted render is finished.
std::string reachedText(const Rendered& rendered, const Scene& scene) {
  const Reached& reached = rendered.reached;
  return fmt::format(
      "with {} of {} samples per pixel in {} of {} rows{}", reached.samples,
      scene.sampler.sampleCount, reached.rows, rendered.image.height,
      reached.unfinished == 0 ? "" : fmt::format(", {} layers unfinished", reached.unfinished));
}

/// `viewed` may be null.
ExitCode run(const RenderCommand& command, ViewedPictures* viewed) {
  const auto start = Clock::now();
  Interruption interruption;
  const auto renderer = startRenderer(command);
  const Scene scene = sceneOf(command);
  checkRender(command, scene);
  const auto exr = outputOf(command, scene);
  const double loadSeconds = since(start);
  if (Interruption::noted()) throw interrupted(kNothing);

  FilmState state = stateOf(command, statePath(exr), scene.camera);
  if (command.options.shard && command.reference)
    state.settings = settingsOfReference(command, scene);
  const auto viewers = viewersOf(command, scene, exr.string(), viewed);
  print(command, "Configuration: " + describe(scene) + "\nRendering .. ");
  flushStandardOutput();  // fail before a long render rather than after it
  Progress progress(!command.quiet);
  const RenderOptions options = optionsOf(command, {&interruption, &progress}, viewers);
  Ended ended = [&] {
    try {
      return renderWith(renderer.get(), scene, options, std::move(state));
    } catch (...) {
      print(command, "failed.\n");
      std::cout.flush();
      throw;
    }
  }();
  const Rendered& rendered = ended.rendered;
  print(command, fmt::format("{}. (took {})\n", rendered.whole() ? "done" : "stopped",
                             timeText(ended.seconds)));
  if (rendered.reached.rows == 0) throw interrupted(kNothing);
  if (rendered.droppedSamples != 0)
    std::cerr << fmt::format(
        "laver: warning: {} samples were negative or not finite and were left out\n",
        rendered.droppedSamples);

  const auto writeStart = Clock::now();
  const std::string resumeText = write(command, scene, exr, ended);
  ended.stats.seconds.load = loadSeconds;
  ended.stats.seconds.write = since(writeStart);
  ended.stats.seconds.total = since(start);
  ended.stats.peakBytes = peakBytes();
  writeStats(command, ended.stats);
  flushStandardOutput();
  if (rendered.whole()) return ExitCode::Ok;
  throw interrupted(fmt::format("{}; see \"{}\"{}", reachedText(rendered, scene),
                                fileOf(rendered, exr).string(), resumeText));
}

}  // namespace

ExitCode run(const RenderCommand& command) {
  if (isTestFile(command.scene)) {
    if (command.options.shard) throw Error(ExitCode::Usage, "--shard: a test has no parts");
    return runTestFile(command);
  }
  if (!command.gui) return run(command, nullptr);
  return runInWindow(command.scene + " - laver",
                     [&](ViewedPictures& viewed) { return run(command, &viewed); });
}

}  // namespace laver
