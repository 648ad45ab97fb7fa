#include "reference/integrators.h"

namespace laver::reference {

/// component| of the shading normal; 0 for a miss.
glm::dvec3 normals(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  return glm::abs(sample.world.surface(*sample.hit).shading);
}

}  // namespace laver::reference
