#pragma once
#include <glm/glm.hpp>

#include "reference/ray.h"
#include "scene/scene.h"

namespace laver::reference {

/// A ray and its range within the clipping planes.
struct CameraRay {
  Ray ray;
  double tmin, tmax;  ///< at the clipping planes, in units of the direction
};

/// A pinhole camera: converts film positions to rays.
class View {
 public:
  /// `centre` is the world position of the reference's origin.
  View(const Camera& camera, glm::dvec3 centre);

  /// `film` is in pixels from the top left. The direction is toWorld times the unit direction in
  /// camera space, so t is not a distance if toWorld has a scale.
  CameraRay through(glm::dvec2 film) const;

 private:
  glm::dvec3 origin_;
  glm::dmat3 toWorld_;
  glm::dvec2 size_;    // pixels
  double halfWidth_;   // of the film at z = 1: tan(fov / 2)
  double near_, far_;  // planes of camera space
};

}  // namespace laver::reference
