#include "reference/openness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace laver::reference {

glm::dvec3 onSphere(glm::dvec2 numbers) {
  const double z = 1.0 - 2.0 * numbers.x, azimuth = 2.0 * std::numbers::pi * numbers.y;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

glm::dvec3 offsetOrigin(const Surface& surface, const glm::dvec3& direction) {
  const double side = glm::dot(surface.geometric, direction);
  return surface.position + std::copysign(surface.offset, side) * surface.geometric;
}

// Directions in the lower half of the sphere are mirrored.
glm::dvec3 uniformAround(const glm::dvec3& n, glm::dvec2 numbers) {
  const glm::dvec3 d = onSphere(numbers);
  const double height = glm::dot(n, d);
  return height < 0.0 ? d - 2.0 * height * n : d;
}

// n plus a uniform point of the unit sphere, normalised.
glm::dvec3 cosineAround(const glm::dvec3& n, glm::dvec2 numbers) {
  const glm::dvec3 d = n + onSphere(numbers);
  const double length = glm::length(d);
  return length > 0.0 ? d / length : n;
}

// Segments that leave the scene are unoccluded: its extent() limits their length.
double openness(const World& world, const Surface& surface, const glm::dvec3& direction,
                double length) {
  const glm::dvec3 from = offsetOrigin(surface, direction);
  return world.blocked(from, from + std::min(length, world.extent()) * direction) ? 0.0 : 1.0;
}

}  // namespace laver::reference
