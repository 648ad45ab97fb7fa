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

double reachOf(const Camera& camera, const Normalisation& space) {
  const glm::dmat4& m = camera.toWorld;
  const dvec3 origin = space.apply(dvec3(m[3]) / m[3].w);
  return (glm::length(origin) + std::numbers::sqrt3) / space.scale;
}

}  // namespace

Rounding::Rounding(const Scene& scene)
    : camera_(scene.camera),
      view_(scene.camera, dvec3(0.0)),
      reach_(reachOf(scene.camera, normalisationOf(scene))) {}

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

double Rounding::sideways(dvec2 film, double distance, double farthest) const {
  return e * (rotationOf(film) * distance + reach_ + kFarthest * farthest);
}

double Rounding::ofHit(dvec2 film, double distance) const {
  return e * (rotationOf(film) + (1.0 + kFarthest) * reach_ / distance) * pixelsPerRadian(film);
}

double Rounding::ofShading(dvec2 film, double distance) const {
  return e * (rotationOf(film) + (1.0 + kFarthest + kShadow) * reach_ / distance) *
         pixelsPerRadian(film);
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
