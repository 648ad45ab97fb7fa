#include <cmath>

#include "reference/bsdf.h"
#include "reference/integrators.h"
#include "reference/openness.h"
#include "reference/texture.h"

namespace laver::reference {

/// Sum over point lights of radiance / r^2 * n.wo * BSDF, where n.wi > 0, n.wo > 0, r^2 > 0 and
/// nothing lies between; for a miss the background.
glm::dvec3 directWhitted(const CameraSample& sample) {
  const Scene& scene = sample.scene;
  glm::dvec3 sum(0.0);
  if (!sample.hit)
    return scene.environment ? backgroundAt(*scene.environment, sample.direction) : sum;
  const Surface surface = sample.world.surface(*sample.hit);
  if (glm::dot(surface.shading, -sample.direction) <= 0.0) return sum;
  for (const PointLight& light : scene.lights) {
    const glm::dvec3 position = light.position - sample.world.centre();
    const glm::dvec3 toLight = position - surface.position;
    const double squared = glm::dot(toLight, toLight);
    if (squared == 0.0) continue;
    const double cosine = glm::dot(surface.shading, toLight) / std::sqrt(squared);
    if (cosine <= 0.0) continue;
    if (sample.world.blocked(offsetOrigin(surface, toLight), position)) continue;
    const BsdfPoint point{surface.mesh->bsdf, surface.albedo, surface.shading};
    sum += light.radiance / squared * cosine *
           point.bsdf.row->eval(point, glm::normalize(-sample.direction), glm::normalize(toLight));
  }
  return sum;
}

}  // namespace laver::reference
