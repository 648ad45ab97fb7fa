#include <cmath>
#include <numbers>

#include "reference/integrators.h"
#include "reference/openness.h"

namespace laver::reference {

/// energy / (4 pi^2) * max(0, n.w) / d^2 of the integrator's own light, if nothing lies between;
/// the material does not matter. 0 for a miss.
glm::dvec3 simple(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  const Surface surface = sample.world.surface(*sample.hit);
  const glm::dvec3 light = sample.integrator.triple("position") - sample.world.centre();
  const glm::dvec3 away = light - surface.position;
  const double distance = glm::length(away), along = glm::dot(surface.shading, away);
  if (along <= 0.0 || sample.world.blocked(offsetOrigin(surface, away), light))
    return glm::dvec3(0.0);
  const double squaredPi = std::numbers::pi * std::numbers::pi;
  return sample.integrator.triple("energy") * (along / (4.0 * squaredPi * std::pow(distance, 3)));
}

}  // namespace laver::reference
