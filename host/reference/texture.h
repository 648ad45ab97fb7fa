#pragma once
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace laver::reference {

/// What a material reflects at texture coordinates.
glm::dvec3 albedoAt(const Bsdf& bsdf, glm::dvec2 uv);

/// What a ray of that direction, of any length but 0, sees where it meets nothing.
glm::dvec3 backgroundAt(const Environment& environment, const glm::dvec3& direction);

}  // namespace laver::reference
