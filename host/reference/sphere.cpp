#include "reference/sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace laver::reference {

namespace {

using LongVec = glm::vec<3, long double, glm::defaultp>;

// The two t of the line's intersections in ascending order; none for a miss.
std::optional<std::pair<long double, long double>> crossings(const WorldSphere& sphere,
                                                             const Ray& ray) {
  const LongVec d(ray.direction), f = LongVec(ray.origin) - LongVec(sphere.centre);
  const long double a = glm::dot(d, d), b = -glm::dot(f, d);
  const auto r = static_cast<long double>(sphere.radius);
  const LongVec nearest = f + b / a * d;
  const long double rest = r * r - glm::dot(nearest, nearest);
  if (!(rest >= 0.0L)) return {};
  const long double q = b + std::copysign(std::sqrt(a * rest), b);
  if (q == 0.0L) return std::pair(0.0L, 0.0L);
  const long double length = std::sqrt(glm::dot(f, f));
  const long double t0 = (length - r) * (length + r) / q, t1 = q / a;
  return t0 < t1 ? std::pair(t0, t1) : std::pair(t1, t0);
}

}  // namespace

std::optional<SphereHit> closest(const WorldSphere& sphere, const Ray& ray, double tmin,
                                 double tmax) {
  const auto both = crossings(sphere, ray);
  if (!both) return {};
  const auto from = static_cast<long double>(tmin), to = static_cast<long double>(tmax);
  const long double t = both->first >= from ? both->first : both->second;
  if (!(t >= from && t <= to)) return {};
  const LongVec p = LongVec(ray.origin) - LongVec(sphere.centre) + t * LongVec(ray.direction);
  return SphereHit{static_cast<double>(t), glm::dvec3(p / std::sqrt(glm::dot(p, p)))};
}

bool crosses(const WorldSphere& sphere, const glm::dvec3& from, const glm::dvec3& to) {
  if (from == to) return false;
  const auto both = crossings(sphere, {from, to - from});
  const auto inside = [](long double t) { return t > 0.0L && t < 1.0L; };
  return both && (inside(both->first) || inside(both->second));
}

glm::dvec2 uvOf(const glm::dvec3& normal) {
  constexpr double pi = std::numbers::pi;
  return {0.5 + std::atan2(normal.y, normal.x) / (2.0 * pi),
          0.5 + std::asin(std::clamp(normal.z, -1.0, 1.0)) / pi};
}

}  // namespace laver::reference
