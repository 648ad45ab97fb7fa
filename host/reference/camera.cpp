#include "reference/camera.h"

#include <cmath>
#include <numbers>

namespace laver::reference {

View::View(const Camera& camera, glm::dvec3 centre)
    : toWorld_(camera.toWorld),
      size_(camera.width, camera.height),
      halfWidth_(std::tan(camera.fov * std::numbers::pi / 360.0)),
      near_(camera.nearClip),
      far_(camera.farClip) {
  const glm::dvec4 origin = camera.toWorld[3];
  origin_ = glm::dvec3(origin) / origin.w - centre;
}

CameraRay View::through(glm::dvec2 film) const {
  const glm::dvec3 local = glm::normalize(
      glm::dvec3((1.0 - 2.0 * film.x / size_.x) * halfWidth_,
                 (1.0 - 2.0 * film.y / size_.y) * halfWidth_ * size_.y / size_.x, 1.0));
  return {{origin_, toWorld_ * local}, near_ / local.z, far_ / local.z};
}

}  // namespace laver::reference
