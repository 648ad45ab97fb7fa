#include "reference/integrators.h"
#include "reference/openness.h"

namespace laver::reference {

/// 1 if nothing is hit within `length` in a direction uniform on the hemisphere of the shading
/// normal, else 0; 1 for a miss.
glm::dvec3 averageVisibility(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(1.0);
  const Surface surface = sample.world.surface(*sample.hit);
  return glm::dvec3(openness(
      sample.world, surface,
      uniformAround(surface.shading, sample.numbers.pair(sample.scene.camera.row->lens ? 2 : 1)),
      sample.integrator.real("length")));
}

}  // namespace laver::reference
