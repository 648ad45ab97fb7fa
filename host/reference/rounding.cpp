#include "reference/rounding.h"

#include <cmath>
#include <numbers>

#include "render/packed.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;
constexpr double e = kUnitRoundoff;

// Constants of the derivation in rounding.h.
constexpr double kSlopes = 2.5;    // part 1
constexpr double kFarthest = 5.0;  // part 2, of F
constexpr double kShadow = 58.0;   // parts 3 and 4, of R

double originOf(const Camera& camera, const Normalisation& space) {
  const glm::dmat4& m = camera.toWorld;
  const dvec3 eye = dvec3(m[3]) / m[3].w;
  const double middle = glm::length(eye + dvec3(m[2]) * space.start - space.centre);
  const double slope = std::tan(camera.fov * std::numbers::pi / 360.0);
  const double side = glm::length(m[0]) * slope;
  const double up = glm::length(m[1]) * slope * camera.height / camera.width;
  return middle + space.start * (side + up);
}

}  // namespace

Rounding::Rounding(const Scene& scene)
    : camera_(scene.camera),
      view_(scene.camera, dvec3(0.0)),
      space_(normalisationOf(scene)),
      start_(space_.start * glm::length(dvec3(scene.camera.toWorld[2]))),
      origin_(originOf(scene.camera, space_)),
      reach_(origin_ + (space_.wide() ? 0.5 * space_.reach : std::numbers::sqrt3) / space_.scale) {}

// Of what is seen at a distance from the camera.
double Rounding::reachAt(double distance) const {
  if (!space_.wide()) return reach_;
  const double fromCentre = std::abs(distance - start_) + 2.0 * origin_;
  return std::min(reach_, origin_ + kPieceReach * std::max(fromCentre, space_.unit));
}

double Rounding::rotationOf(dvec2 film) const {
  const dvec2 size(camera_.width, camera_.height);
  const dvec2 slope = (1.0 - 2.0 * film / size) * std::tan(camera_.fov * std::numbers::pi / 360.0) *
                      dvec2(1.0, size.y / size.x);
  const dvec3 x = dvec3(camera_.toWorld[0]) * slope.x, y = dvec3(camera_.toWorld[1]) * slope.y;
  const dvec3 z(camera_.toWorld[2]);
  const double parts =
      3.0 * (glm::length(x) + glm::length(y)) + glm::length(z) + glm::length(x + y);
  return parts / glm::length(x + y + z) + 1.0 + kSlopes;
}

// Directions change least along the minor axis of the ellipse to which the unit sphere maps a
// pixel's circle.
double Rounding::pixelsPerRadian(dvec2 film) const {
  const auto direction = [&](double x, double y) {
    return glm::normalize(view_.through(film + dvec2(x, y)).ray.direction);
  };
  const dvec3 x = direction(0.5, 0.0) - direction(-0.5, 0.0);
  const dvec3 y = direction(0.0, 0.5) - direction(0.0, -0.5);
  const double xx = glm::dot(x, x), yy = glm::dot(y, y), xy = glm::dot(x, y);
  return 1.0 / std::sqrt(0.5 * (xx + yy - std::hypot(xx - yy, 2.0 * xy)));
}

double Rounding::sideways(dvec2 film, double distance, double farthest, double corner) const {
  return e * (rotationOf(film) * (distance - start_) + startError() + origin_ + corner +
              kFarthest * farthest);
}

double Rounding::ofHit(dvec2 film, double distance) const {
  return e *
         (rotationOf(film) * (1.0 - start_ / distance) +
          (startError() + (1.0 + kFarthest) * reachAt(distance)) / distance) *
         pixelsPerRadian(film);
}

double Rounding::ofShading(dvec2 film, double distance, double blocker) const {
  const double shadow = std::max(reachAt(distance), reachAt(distance + blocker));
  return ofHit(film, distance) + e * kShadow * shadow / distance * pixelsPerRadian(film);
}

double Rounding::ofBackground(dvec2 film) const {
  return e * (rotationOf(film) + 7.0 + std::numbers::sqrt2 * (25.0 + 12.0)) * pixelsPerRadian(film);
}

double cornerShift(const dvec3& p, const dvec3& direction, dvec2 sheared) {
  const dvec3 d = glm::abs(direction), size = glm::abs(p);
  const int z = d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const dvec2 slope(d[x] / d[z], d[y] / d[z]);
  return e * glm::length(dvec2(size[x], size[y]) + 7.0 * size[z] * slope + glm::abs(sheared));
}

double edgeShift(dvec2 a, dvec2 b) {
  const double length = glm::length(b - a);
  return length > 0.0 ? e * (std::abs(a.x * b.y) + std::abs(a.y * b.x)) / length : 0.0;
}

}  // namespace laver
