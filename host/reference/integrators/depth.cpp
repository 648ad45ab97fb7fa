#include "reference/integrators.h"

namespace laver::reference {

/// 1 / distance from the camera, in world units.
glm::dvec3 depth(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  return glm::dvec3(1.0 / (sample.hit->t * glm::length(sample.direction)));
}

}  // namespace laver::reference
