#include "commands/scene_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "render/sample_map.h"
#include "render/strips.h"

namespace laver {
namespace {

/// Layers may need materials and lights, too.
SceneOverrides overridesOf(const SceneCommand& command) {
  SceneOverrides overrides = command.overrides;
  overrides.noriCompat = command.options.noriCompat;
  for (const Shown& shown : shownBeside(command.options.more, command.options.layers))
    overrides.shading = overrides.shading || shades(*shown.integrator.row);
  return overrides;
}

void checkOptions(const RenderOptions& options, const Scene& scene) {
  const Camera& camera = scene.camera;
  if (const auto& crop = options.crop;
      crop && (crop->x0 < 0 || crop->y0 < 0 || crop->x1 > camera.width ||
               crop->y1 > camera.height || crop->x0 >= crop->x1 || crop->y0 >= crop->y1))
    throw Error(ExitCode::Usage,
                fmt::format("--crop {},{},{},{}: expected 0 <= x0 < x1 <= {}, 0 <= y0 < y1 <= {}",
                            crop->x0, crop->y0, crop->x1, crop->y1, camera.width, camera.height));
  const Crop core = coreOf(camera, options);
  if (const auto& shard = options.shard; shard && shard->count > core.y1 - core.y0)
    throw Error(ExitCode::Usage,
                fmt::format("--shard {}: a picture of {} rows has that many parts at most",
                            textOf(*shard), core.y1 - core.y0));
  if (options.error != 0.0 && maxSamplesOf(scene.sampler) == 0)
    throw Error(
        ExitCode::Usage,
        fmt::format("--error: {} samples per pixel are too few to choose from; the minimum is "
                    "--spp {}",
                    scene.sampler.sampleCount, shared::CELL_STEP));
}

void checkError(const RenderCommand& command) {
  if (command.options.error == 0.0) return;
  if (command.reference)
    throw Error(ExitCode::Usage, "--error: the reference takes the scene's number of samples");
  if (command.resume)
    throw Error(ExitCode::Usage,
                "--error: an adaptive render always starts from the beginning; --resume "
                "requires the same number of samples in every pixel");
}

void checkVariance(const RenderCommand& command, const Scene& scene) {
  if (!asks(command.options.layers, layers::variance)) return;
  const auto refuse = [](const std::string& why) {
    throw Error(ExitCode::Usage, "--layers variance: " + why);
  };
  if (command.options.error != 0.0)
    refuse("not with --error, whose pixels have unequal numbers of samples");
  if (command.resume) refuse("not with --resume, which keeps sums of samples only");
  if (scene.sampler.sampleCount < 2)
    refuse("one sample per pixel has none; the minimum is --spp 2");
}

/// Channels of all layers.
std::size_t layerChannels(const RenderOptions& options) {
  std::size_t count = centreChannels(options.layers).size();
  for (const Shown& shown : shownBeside(options.more, options.layers))
    count += shown.channels.size();
  for (const LayerRow* layer : {&layers::samples, &layers::variance})
    if (asks(options.layers, *layer)) count += layer->channels.size();
  return count;
}

/// Checks that the picture and its files fit in memory: 20 bytes per pixel, measured at 16384 x
/// 16384. Sums that are kept take 32 more, and their file as many again.
void checkMemory(const RenderCommand& command, const Scene& scene) {
  const Crop core = coreOf(scene.camera, command.options);
  const int width = core.x1 - core.x0, rows = rowsOf(stripsOf(scene, command.options));
  // Per channel of a layer: 4 bytes in its own image, 4 in the joined one, 4 for the file. The sums
  // for the variance take 104 bytes, rounded up.
  const std::uint64_t sums = asks(command.options.layers, layers::variance) ? 128 : 0;
  const std::uint64_t bytes = (command.resume ? 88 : 24) + sums +
                              12 * layerChannels(command.options) +
                              (command.displayServer ? 12 : 0) +
                              (command.gui ? 12 + 4 * layerChannels(command.options) : 0);
  const std::uint64_t needed =
      bytes * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(rows);
  const std::uint64_t available = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                                  static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  if (needed > available)
    throw Error(ExitCode::Device,
                fmt::format("a film of {}x{} pixels needs {} MiB of memory, the machine has {}",
                            width, rows, needed >> 20, available >> 20));
}

void warnOfMissingUvs(const RenderOptions& options, const Scene& scene) {
  if (!asks(options.layers, layers::uv)) return;
  for (const Mesh& mesh : scene.meshes)
    if (mesh.uvs.empty() && !mesh.sphere)
      std::cerr << fmt::format(
          "laver: warning: \"{}\" has no texture coordinates; layer uv is 0 there\n", mesh.name);
}

}  // namespace

Scene sceneOf(const std::string& file, const SceneOverrides& overrides) {
  LoadedScene loaded = loadScene(file, overrides);
  for (const auto& warning : loaded.warnings) std::cerr << warning << '\n';
  return std::move(loaded.scene);
}

Scene sceneOf(const SceneCommand& command) {
  Scene scene = sceneOf(command.scene, overridesOf(command));
  checkOptions(command.options, scene);
  return scene;
}

void checkRender(const RenderCommand& command, const Scene& scene) {
  warnOfMissingUvs(command.options, scene);
  checkError(command);
  checkVariance(command, scene);
  checkMemory(command, scene);
}

}  // namespace laver
