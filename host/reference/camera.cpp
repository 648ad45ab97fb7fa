#include "reference/camera.h"

#include <cmath>
#include <numbers>

namespace laver::reference {

View::View(const Camera& camera, glm::dvec3 centre)
    : camera_(camera),
      toWorld_(camera.toWorld),
      size_(camera.width, camera.height),
      halfWidth_(std::tan(camera.fov * std::numbers::pi / 360.0)),
      near_(camera.nearClip),
      far_(camera.farClip) {
  const glm::dvec4 origin = camera.toWorld[3];
  origin_ = glm::dvec3(origin) / origin.w - centre;
}

glm::dvec3 View::local(glm::dvec2 film) const {
  return {(1.0 - 2.0 * film.x / size_.x) * halfWidth_,
          (1.0 - 2.0 * film.y / size_.y) * halfWidth_ * size_.y / size_.x, 1.0};
}

CameraRay View::ray(const glm::dvec3& origin, const glm::dvec3& local) const {
  const glm::dvec3 unit = glm::normalize(local);
  return {{origin, toWorld_ * unit}, near_ / unit.z, far_ / unit.z};
}

CameraRay View::through(glm::dvec2 film) const { return ray(origin_, local(film)); }

CameraRay View::through(glm::dvec2 film, const Numbers& numbers) const {
  if (!camera_.row->lens) return through(film);
  const glm::dvec2 pair = numbers.pair(1);
  const double radius = camera_.lensRadius * std::sqrt(pair.x);
  const double azimuth = 2.0 * std::numbers::pi * pair.y;
  const glm::dvec3 point(radius * std::cos(azimuth), radius * std::sin(azimuth), 0.0);
  const glm::dvec3 inFocus = local(film) * camera_.focalDistance;
  return ray(origin_ + toWorld_ * point / camera_.toWorld[3].w, inFocus - point);
}

}  // namespace laver::reference
