#include <cmath>
#include <numbers>

#include "reference/texture.h"
#include "reference/world.h"

namespace laver::reference {

namespace {

// The shadow ray starts off the surface, on the light's side, so that the surface's own plane and
// that of its neighbours do not lie between.
bool lit(const World& world, const Surface& surface, const glm::dvec3& light) {
  const double side = glm::dot(surface.geometric, light - surface.position);
  const glm::dvec3 from =
      surface.position + std::copysign(surface.offset, side) * surface.geometric;
  return !world.tree().blocked(from, light);
}

glm::dvec3 directWhitted(const World& world, const Scene& scene, const glm::dvec3& direction,
                         const Surface& surface) {
  glm::dvec3 sum(0.0);
  if (glm::dot(surface.shading, -direction) <= 0.0) return sum;
  for (const PointLight& light : scene.lights) {
    const glm::dvec3 position = light.position - world.centre();
    const glm::dvec3 way = position - surface.position;
    const double squared = glm::dot(way, way);
    if (squared == 0.0) continue;
    const double cosine = glm::dot(surface.shading, way) / std::sqrt(squared);
    if (cosine <= 0.0 || !lit(world, surface, position)) continue;
    sum += light.radiance / squared * cosine * surface.albedo / std::numbers::pi;
  }
  return sum;
}

}  // namespace

glm::dvec3 radiance(const World& world, const Scene& scene, const CameraRay& camera) {
  const auto hit = world.tree().closest(camera.ray, camera.tmin, camera.tmax);
  if (!hit && scene.environment && scene.integrator == Integrator::DirectWhitted)
    return backgroundAt(*scene.environment, camera.ray.direction);
  if (!hit) return glm::dvec3(0.0);
  switch (scene.integrator) {
    case Integrator::Normals:
      return glm::abs(world.surface(*hit).shading);
    case Integrator::DirectWhitted:
      return directWhitted(world, scene, camera.ray.direction, world.surface(*hit));
    case Integrator::Depth:
      return glm::dvec3(1.0 / (hit->t * glm::length(camera.ray.direction)));
  }
  return glm::dvec3(0.0);
}

}  // namespace laver::reference
