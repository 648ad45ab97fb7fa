#include <numbers>

#include "reference/emitter.h"
#include "reference/openness.h"

namespace laver::reference {

glm::dvec3 constant(const Environment& environment, const glm::dvec3&) {
  return environment.radiance;
}

DirectionSample constantDirection(const Environment&, glm::ivec2, std::size_t, glm::dvec2 numbers) {
  return {onSphere(numbers), 0.25 / std::numbers::pi};
}

CellDensity constantDensity(const Environment&, glm::ivec2, const glm::dvec3&) {
  return {0, 0.25 / std::numbers::pi};
}

}  // namespace laver::reference
