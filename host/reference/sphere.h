#pragma once
#include <cstdint>
#include <optional>

#include "reference/ray.h"

namespace laver::reference {

/// A hollow sphere of the scene.
struct WorldSphere {
  glm::dvec3 centre;  ///< relative to World::centre()
  double radius;
  std::uint32_t id;  ///< numbered with the triangles
  std::size_t mesh;
};

/// The hit of a ray on a sphere.
struct SphereHit {
  double t;
  glm::dvec3 normal;  ///< unit, outwards
};

/// The first intersection with t in [tmin, tmax], in long double: from the distance of the line
/// from the centre, and the root that does not cancel.
std::optional<SphereHit> closest(const WorldSphere& sphere, const Ray& ray, double tmin,
                                 double tmax);

/// Texture coordinates of the point with that normal: longitude from -x over -y, +x and +y, and
/// latitude from -z, both mapped to [0, 1]. At the poles u is 1/2.
glm::dvec2 uvOf(const glm::dvec3& normal);

/// Whether the segment between two points intersects the sphere.
bool crosses(const WorldSphere& sphere, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace laver::reference
