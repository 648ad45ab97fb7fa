#include <cmath>
#include <numbers>

#include "reference/texture.h"
#include "reference/world.h"

namespace laver::reference {

namespace {

// The shadow ray starts off the surface, on the light's side, so that the surface's own plane and
// that of its neighbours do not lie between.
glm::dvec3 beside(const Surface& surface, const glm::dvec3& way) {
  const double side = glm::dot(surface.geometric, way);
  return surface.position + std::copysign(surface.offset, side) * surface.geometric;
}

bool lit(const World& world, const Surface& surface, const glm::dvec3& light) {
  return !world.blocked(beside(surface, light - surface.position), light);
}

// Uniform on the sphere by its height and azimuth.
glm::dvec3 onSphere(glm::dvec2 numbers) {
  const double z = 1.0 - 2.0 * numbers.x, azimuth = 2.0 * std::numbers::pi * numbers.y;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

// Uniform on the hemisphere of n: the lower half of the sphere is mirrored.
glm::dvec3 uniformAround(const glm::dvec3& n, glm::dvec2 numbers) {
  const glm::dvec3 d = onSphere(numbers);
  const double height = glm::dot(n, d);
  return height < 0.0 ? d - 2.0 * height * n : d;
}

// With density cosine / pi: the unit sphere around n's tip, seen from its foot.
glm::dvec3 cosineAround(const glm::dvec3& n, glm::dvec2 numbers) {
  const glm::dvec3 d = n + onSphere(numbers);
  const double length = glm::length(d);
  return length > 0.0 ? d / length : n;
}

// 1 if nothing lies within `length` of the surface in a direction. What leaves the tree's box is
// free; twice its diagonal is as good as infinity.
double openness(const World& world, const Surface& surface, const glm::dvec3& direction,
                double length) {
  const glm::dvec3 from = beside(surface, direction);
  return world.blocked(from, from + std::min(length, world.extent()) * direction) ? 0.0 : 1.0;
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

glm::dvec3 radiance(const World& world, const Scene& scene, Integrator shown,
                    const CameraRay& camera, glm::dvec2 numbers) {
  const auto hit = world.closest(camera.ray, camera.tmin, camera.tmax);
  if (!hit && scene.environment && shown == Integrator::DirectWhitted)
    return backgroundAt(*scene.environment, camera.ray.direction);
  if (!hit) return glm::dvec3(shown == Integrator::AverageVisibility ? 1.0 : 0.0);
  switch (shown) {
    case Integrator::Normals:
      return glm::abs(world.surface(*hit).shading);
    case Integrator::DirectWhitted:
      return directWhitted(world, scene, camera.ray.direction, world.surface(*hit));
    case Integrator::Depth:
      return glm::dvec3(1.0 / (hit->t * glm::length(camera.ray.direction)));
    case Integrator::AverageVisibility: {
      const Surface s = world.surface(*hit);
      return glm::dvec3(openness(world, s, uniformAround(s.shading, numbers), scene.avLength));
    }
    case Integrator::AmbientOcclusion: {
      const Surface s = world.surface(*hit);
      return glm::dvec3(openness(world, s, cosineAround(s.shading, numbers),
                                 std::numeric_limits<double>::infinity()));
    }
    case Integrator::ShadingNormal:
      return world.surface(*hit).shading;
    case Integrator::Albedo:
      return world.surface(*hit).albedo;
  }
  return glm::dvec3(0.0);
}

}  // namespace laver::reference
