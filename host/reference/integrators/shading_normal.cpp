#include "reference/integrators.h"

namespace laver::reference {

/// The shading normal, signs kept; 0 for a miss.
glm::dvec3 shadingNormal(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  return sample.world.surface(*sample.hit).shading;
}

}  // namespace laver::reference
