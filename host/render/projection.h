#pragma once
#include "render/footprint.h"
#include "render/scene_data.h"

namespace laver {

/// Pixels whose camera rays may meet a box of the tree; nothing where the kernels trace no rays.
Footprint footprintOf(const SceneData& data);

}  // namespace laver
