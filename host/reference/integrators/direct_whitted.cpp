#include <cmath>

#include "reference/bsdf.h"
#include "reference/emitter.h"
#include "reference/integrators.h"
#include "reference/openness.h"
#include "reference/texture.h"

namespace laver::reference {

/// Sum over the unoccluded point lights of radiance / r^2 * n.wo * BSDF, where n.wi > 0, n.wo > 0
/// and r^2 > 0; for a miss the background.
glm::dvec3 directWhitted(const CameraSample& sample) {
  glm::dvec3 sum(0.0);
  if (!sample.hit) {
    const auto& sky = sample.scene.environment;
    return sky ? sky->row->background(*sky, sample.direction) : sum;
  }
  Surface surface = sample.world.surface(*sample.hit);
  surface.shading = bsdfNormal(surface);
  if (glm::dot(surface.shading, -sample.direction) <= 0.0) return sum;
  const BsdfPoint point(surface.mesh->bsdf, surface.textureUv, surface.shading, surface.tangent);
  const glm::dvec3 wi = glm::normalize(-sample.direction);
  for (const PointLight& light : sample.world.lights()) {
    const LightSample arriving = light.row->sample(light, surface.position, sample.world.extent());
    const glm::dvec3 toLight = arriving.position - surface.position;
    const double squared = glm::dot(toLight, toLight);
    if (squared == 0.0) continue;
    const double cosine = glm::dot(surface.shading, toLight) / std::sqrt(squared);
    if (cosine <= 0.0) continue;
    if (sample.world.blocked(offsetOrigin(surface, toLight), arriving.position)) continue;
    sum += arriving.radiance * cosine * point.bsdf.row->eval(point, wi, glm::normalize(toLight));
  }
  return sum;
}

}  // namespace laver::reference
