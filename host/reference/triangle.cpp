#include "reference/triangle.h"

#include <algorithm>

namespace laver::reference {

Triangle::Triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                   std::uint32_t number)
    : corner{a, b, c}, place{0, 1, 2}, id(number) {
  const std::array<glm::dvec3, 3> given = corner;
  std::sort(place.begin(), place.end(), [&](std::uint8_t i, std::uint8_t j) {
    const glm::dvec3 &p = given[i], &q = given[j];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    return p.z < q.z;
  });
  for (std::size_t i = 0; i < 3; ++i) corner[i] = given[place[i]];
}

Weights Triangle::asGiven(const Weights& sorted) const {
  Weights weights{};
  for (std::size_t i = 0; i < 3; ++i) weights[place[i]] = sorted[i];
  return weights;
}

LongVec Triangle::normal() const {
  const LongVec origin(corner[0]);
  return glm::cross(LongVec(corner[1]) - origin, LongVec(corner[2]) - origin);
}

double planeT(const Triangle& triangle, const Ray& ray, double crossingT) {
  const Shear shear(ray);
  std::array<double, 3> t{};
  for (std::size_t i = 0; i < 3; ++i) t[i] = shear(triangle.corner[i]).z / shear.depth();
  const auto [nearest, farthest] = std::minmax({t[0], t[1], t[2]});
  const LongVec normal = triangle.normal();
  const long double speed = glm::dot(normal, LongVec(ray.direction));
  if (speed == 0.0L) return crossingT;
  const LongVec toCorner = LongVec(triangle.corner[0]) - LongVec(ray.origin);
  return std::clamp(static_cast<double>(glm::dot(normal, toCorner) / speed), nearest, farthest);
}

bool ahead(const Triangle& triangle, const Ray& ray) {
  const LongVec normal = triangle.normal();
  const long double side = glm::dot(normal, LongVec(ray.origin) - LongVec(triangle.corner[0]));
  const long double speed = glm::dot(normal, LongVec(ray.direction));
  return (side < 0.0L && speed > 0.0L) || (side > 0.0L && speed < 0.0L);
}

bool separates(const Triangle& triangle, const glm::dvec3& a, const glm::dvec3& b) {
  const LongVec normal = triangle.normal(), origin(triangle.corner[0]);
  const long double sideA = glm::dot(normal, LongVec(a) - origin);
  const long double sideB = glm::dot(normal, LongVec(b) - origin);
  return (sideA < 0.0L && sideB > 0.0L) || (sideA > 0.0L && sideB < 0.0L);
}

}  // namespace laver::reference
