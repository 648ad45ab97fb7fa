#include "reference/integrators.h"
#include "reference/openness.h"

namespace laver::reference {

/// 1 if nothing is hit within `length` diagonals of the scene in a direction with density cosine /
/// pi around the shading normal, else 0; 0 for a miss.
glm::dvec3 ambientOcclusion(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  const Surface surface = sample.world.surface(*sample.hit);
  return glm::dvec3(openness(
      sample.world, surface,
      cosineAround(surface.shading, sample.numbers.pair(sample.scene.camera.row->lens ? 2 : 1)),
      sample.integrator.real("length") * sample.world.diagonal()));
}

}  // namespace laver::reference
