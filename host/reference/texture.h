#pragma once
#include <glm/glm.hpp>

#include "scene/bsdfs.h"

namespace laver::reference {

/// What a material reflects at texture coordinates.
glm::dvec3 albedoAt(const Bsdf& bsdf, glm::dvec2 uv);

/// Linear light of a picture at x, y in pixels: weight 1 - |distance| on each axis for the pixels
/// whose centres are less than 1 away. Beyond the left and the right border it repeats; beyond the
/// others it repeats or the border goes on.
glm::dvec3 interpolated(const Picture& picture, bool raw, double x, double y, bool repeats);

}  // namespace laver::reference
