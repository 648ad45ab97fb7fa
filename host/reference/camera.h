#pragma once
#include <glm/glm.hpp>

#include "reference/ray.h"
#include "reference/sampler.h"
#include "scene/scene.h"

namespace laver::reference {

/// A ray and its range within the clipping planes.
struct CameraRay {
  Ray ray;
  double tmin, tmax;  ///< at the clipping planes, in units of the direction
};

/// A camera: converts film positions to rays.
class View {
 public:
  /// `centre` is the world position of the reference's origin.
  View(const Camera& camera, glm::dvec3 centre);

  /// `film` is in pixels from the top left. The direction is toWorld times the unit direction in
  /// camera space, so t is not a distance if toWorld has a scale.
  CameraRay through(glm::dvec2 film) const;
  /// The same through a point of the lens, if there is one, by the numbers of dimension 1.
  CameraRay through(glm::dvec2 film, const Numbers& numbers) const;

 private:
  glm::dvec3 local(glm::dvec2 film) const;  // z = 1
  CameraRay ray(const glm::dvec3& origin, const glm::dvec3& local) const;

  Camera camera_;
  glm::dvec3 origin_;
  glm::dmat3 toWorld_;
  glm::dvec2 size_;    // pixels
  double halfWidth_;   // of the film at z = 1: tan(fov / 2)
  double near_, far_;  // planes of camera space
};

}  // namespace laver::reference
