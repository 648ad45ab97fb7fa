#include "reference/integrators.h"

namespace laver::reference {

/// The shading normal with its signs.
glm::dvec3 shadingNormal(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  return sample.world.surface(*sample.hit).shading;
}

}  // namespace laver::reference
