#include "reference/integrators.h"

namespace laver::reference {

/// The surface's albedo; 0 for a miss.
glm::dvec3 albedo(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  return sample.world.surface(*sample.hit).albedo;
}

}  // namespace laver::reference
