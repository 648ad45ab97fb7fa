#pragma once
#include <glm/glm.hpp>
#include <string>

#include "render/packed.h"
#include "scene/scene.h"

namespace laver {

/// A hit and how far float arithmetic may take the kernels from it. e = 2^-24; lengths are in
/// normalised space, where vertices lie in [-1, 1]^3 and O = max |camera| + 1 bounds them all.
struct Bounds {
  double pixels;    ///< how far a ray may pass from where the reference's does
  double depth;     ///< relative
  double normal;    ///< of a component of the shading normal
  double radiance;  ///< absolute, per channel
  std::string cause;
};

/// Bounds at a triangle of a scene, by the scene alone.
class BoundsOf {
 public:
  explicit BoundsOf(const Scene& scene);

  /// At barycentric weights u, v of triangle `id`, numbered in file order over all meshes.
  Bounds at(std::uint32_t id, double u, double v) const;

  /// How far rays may pass from one another at a distance from the camera, in pixels.
  double pixelsAt(double distance) const;
  /// How far a ray's direction may be off, and the place of a background that it sees, in pixels.
  double pixelsOfBackground() const;
  /// In scene units.
  double distanceOf(std::uint32_t id, double u, double v) const;

 private:
  struct Place {
    const Mesh* mesh;
    glm::uvec3 corners;
  };
  Place placeOf(std::uint32_t id) const;

  const Scene& scene_;
  Normalisation space_;
  glm::dvec3 eye_;
  double reach_;         // O
  double pixelsAcross_;  // for a slope of 1
};

}  // namespace laver
