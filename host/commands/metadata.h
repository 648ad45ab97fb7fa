#pragma once
#include "image/io.h"
#include "render/rendered.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace laver {

/// The attributes of a picture's EXR file. Of a picture that is not whole they also say
/// how many samples a pixel were wanted and how many rows hold some and all of them.
Metadata metadataOf(const Scene& scene, const Rendered& rendered, const Stats& stats,
                    double renderSeconds);

/// Camera space to normalised device coordinates: x from 0 at the left edge of the film to 1 at
/// the right, y from 0 at the top, z from 0 at the near to 1 at the far plane.
glm::dmat4 cameraToNdc(const Camera& camera);

}  // namespace laver
