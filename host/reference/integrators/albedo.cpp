#include "reference/integrators.h"
#include "reference/texture.h"

namespace laver::reference {

/// The surface's albedo; 0 for a miss.
glm::dvec3 albedo(const CameraSample& sample) {
  if (!sample.hit) return glm::dvec3(0.0);
  const Surface surface = sample.world.surface(*sample.hit);
  return albedoAt(surface.mesh->bsdf, surface.textureUv);
}

}  // namespace laver::reference
