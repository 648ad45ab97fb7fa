#include <limits>

#include "reference/integrators.h"
#include "reference/openness.h"

namespace laver::reference {

/// 1 if the ray in a direction with density cosine / pi around the shading normal leaves the scene,
/// else 0; 0 for a miss.
glm::dvec3 ambientOcclusion(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  const Surface surface = sample.world.surface(*sample.hit);
  return glm::dvec3(openness(sample.world, surface,
                             cosineAround(surface.shading, sample.numbers.pair(1)),
                             std::numeric_limits<double>::infinity()));
}

}  // namespace laver::reference
