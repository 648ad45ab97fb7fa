#pragma once
#include "render/scene_data.h"

namespace laver {

/// Fills the camera's part of data.params from data.space; needs it set.
void packCamera(const Scene& scene, SceneData& data);

/// Fills the filter's part of data.params.
void packFilter(const Filter& filter, SceneData& data);

}  // namespace laver
