#include "reference/integrators.h"

namespace laver::reference {

/// |component| of the normal of the triangle's plane or the sphere; 0 for a miss.
glm::dvec3 geometricNormals(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  return glm::abs(sample.world.surface(*sample.hit).geometric);
}

}  // namespace laver::reference
