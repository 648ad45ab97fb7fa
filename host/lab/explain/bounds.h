#pragma once
#include <glm/glm.hpp>
#include <string>

#include "reference/reference.h"
#include "reference/rounding.h"
#include "render/packed.h"
#include "scene/scene.h"

namespace laver {

/// Bounds of the difference between the kernels' float values at a hit and the reference's.
struct ValueBounds {
  double depth;     ///< relative
  double normal;    ///< angle of the shading normal
  double radiance;  ///< of direct light, absolute, per channel, without occlusion
  std::string cause;
};

/// Bounds at the hits of a scene's camera rays, derived from the scene alone, to first order in e =
/// 2^-24.
class BoundsOf {
 public:
  /// Both must outlive this object.
  BoundsOf(const Scene& scene, const Rounding& rounding);

  /// `hit` is the hit of the ray through `film`.
  ValueBounds at(glm::dvec2 film, const Reference::Hit& hit) const;

 private:
  struct Local;
  Local onTriangle(glm::dvec2 film, const Reference::Hit& hit, const Mesh& mesh,
                   const glm::uvec3& corners) const;
  Local onSphere(glm::dvec2 film, const Reference::Hit& hit, const Sphere& sphere) const;
  double sideways(glm::dvec2 film, double distance, double farthest, double corner) const;

  const Scene& scene_;
  const Rounding& rounding_;
  const Normalisation& space_;
  glm::dvec3 eye_;
};

}  // namespace laver
