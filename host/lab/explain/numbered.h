#pragma once
#include <optional>

#include "scene/scene.h"

namespace laver {

/// A scene whose picture by the integrator `normals` tells which triangle each sample met: every
/// triangle has corners of its own, with one normal that stands for its number. Coordinates, and so
/// the kernels' tree, are the same.
Scene numbered(const Scene& scene);

/// The number that a pixel of that picture tells; none for a miss.
std::optional<std::uint32_t> numberOf(const Scene& scene, glm::dvec3 pixel);

}  // namespace laver
