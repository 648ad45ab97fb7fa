#pragma once
#include <glm/glm.hpp>

#include "reference/world.h"

namespace laver::reference {

/// Origin of a shadow ray: offset from the surface to the side of its direction, so that neither
/// the surface's plane nor those of its neighbours are hit.
glm::dvec3 offsetOrigin(const Surface& surface, const glm::dvec3& direction);

/// Uniform on the sphere, by its height and azimuth.
glm::dvec3 onSphere(glm::dvec2 numbers);

/// Uniform on the hemisphere of n.
glm::dvec3 uniformAround(const glm::dvec3& n, glm::dvec2 numbers);

/// With density cosine / pi around n.
glm::dvec3 cosineAround(const glm::dvec3& n, glm::dvec2 numbers);

/// 1 if nothing is hit within `length` in a direction from the surface, else 0.
double openness(const World& world, const Surface& surface, const glm::dvec3& direction,
                double length);

}  // namespace laver::reference
