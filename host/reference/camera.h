#pragma once
#include <glm/glm.hpp>

#include "reference/ray.h"
#include "scene/scene.h"

namespace laver::reference {

/// A ray and the part of it that the camera sees.
struct CameraRay {
  Ray ray;
  double tmin, tmax;  ///< the clipping planes, in units of the ray's direction
};

/// Pinhole camera, film position to ray.
class View {
 public:
  /// `centre` is the world position that becomes the origin.
  View(const Camera& camera, glm::dvec3 centre);

  /// `film` in pixels from the top left. The direction is toWorld times the unit direction of
  /// camera space: under a scaled camera t is not a distance.
  CameraRay through(glm::dvec2 film) const;

 private:
  glm::dvec3 origin_;
  glm::dmat3 toWorld_;
  glm::dvec2 size_;    // pixels
  double halfWidth_;   // of the film at z = 1: tan(fov / 2)
  double near_, far_;  // planes of camera space
};

}  // namespace laver::reference
