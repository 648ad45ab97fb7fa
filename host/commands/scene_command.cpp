#include <fmt/format.h>

#include "commands/commands.h"
#include "render/sample_map.h"

namespace laver {

SceneOverrides overridesOf(const SceneCommand& command) {
  SceneOverrides overrides = command.overrides;
  overrides.noriCompat = command.options.noriCompat;
  for (const Shown& shown : shownBeside(command.options.more, command.options.layers))
    overrides.shading = overrides.shading || shades(*shown.integrator.row);
  return overrides;
}

void checkOptions(const SceneCommand& command, const Scene& scene) {
  const Camera& camera = scene.camera;
  if (const auto& crop = command.options.crop;
      crop && (crop->x0 < 0 || crop->y0 < 0 || crop->x1 > camera.width ||
               crop->y1 > camera.height || crop->x0 >= crop->x1 || crop->y0 >= crop->y1))
    throw Error(ExitCode::Usage,
                fmt::format("--crop {},{},{},{}: expected 0 <= x0 < x1 <= {}, 0 <= y0 < y1 <= {}",
                            crop->x0, crop->y0, crop->x1, crop->y1, camera.width, camera.height));
  if (command.options.error != 0.0 && mostOf(scene.sampler) == 0)
    throw Error(ExitCode::Usage,
                fmt::format("--error: {} samples a pixel are too few to choose from; --spp {} is "
                            "the least",
                            scene.sampler.sampleCount, shared::CELL_STEP));
}

}  // namespace laver
