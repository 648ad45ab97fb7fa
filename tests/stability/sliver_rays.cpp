#include "stability/sliver_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "stability/exact.h"

namespace laver::test {
namespace {

using glm::dvec3;

dvec3 unitVector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

dvec3 acrossTo(dvec3 v, std::mt19937& random) {
  return glm::normalize(glm::cross(v, unitVector(random)));
}

}  // namespace

SliverRay sliverRay(double aspect, double distance, double minCosine, double maxCosine,
                    std::mt19937& random) {
  std::uniform_real_distribution<double> place(-0.9, 0.9), unit(0.0, 1.0);
  const dvec3 along = unitVector(random), up = acrossTo(along, random);
  const dvec3 a(place(random), place(random), place(random));
  const double length = 0.1;
  std::array<glm::vec3, 3> corners{a, a + length * along,
                                   a + length * (unit(random) * along + up / aspect)};
  std::sort(corners.begin(), corners.end(), [](glm::vec3 p, glm::vec3 q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  SliverRay result{};
  result.triangle = {corners[0], 0, corners[1], 0, corners[2], 0};

  double u = unit(random), v = unit(random);
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const dvec3 target =
      dvec3(corners[0]) * (1.0 - u - v) + dvec3(corners[1]) * u + dvec3(corners[2]) * v;
  const dvec3 n = exact::normal(result.triangle);
  result.cosine = minCosine + (maxCosine - minCosine) * unit(random);
  const dvec3 side = acrossTo(n, random);
  const dvec3 direction = n * result.cosine + side * std::sqrt(1.0 - result.cosine * result.cosine);
  const glm::vec3 origin(target - distance * direction);
  result.ray = {origin, 0.0F, glm::vec3(target - dvec3(origin)), 1e37F};
  return result;
}

}  // namespace laver::test
