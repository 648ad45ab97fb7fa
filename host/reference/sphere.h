#pragma once
#include <cstdint>
#include <optional>

#include "reference/ray.h"

namespace laver::reference {

/// A sphere of the scene, hollow.
struct Ball {
  glm::dvec3 centre;  ///< relative to World::centre()
  double radius;
  std::uint32_t id;  ///< numbered with the triangles
  std::size_t mesh;
};

/// Where a ray meets it.
struct BallHit {
  double t;
  glm::dvec3 normal;  ///< unit, outwards
};

/// The first crossing with t in [tmin, tmax], in long double: by the distance of the line from the
/// centre, and the root that does not cancel.
std::optional<BallHit> closest(const Ball& ball, const Ray& ray, double tmin, double tmax);

/// Texture coordinates of the point with that normal: longitude from -x over -y, +x and +y, and
/// latitude from -z, both taken to [0, 1]. At the poles u is 1/2.
glm::dvec2 uvOf(const glm::dvec3& normal);

/// Whether the line between two points crosses it.
bool crosses(const Ball& ball, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace laver::reference
