#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/facets.h"
#include "reference/openness.h"

namespace laver::reference {

namespace {

double lobeShare(const BsdfPoint& point) {
  const double diffuse = luminance(point.color("diffuseReflectance"));
  const double specular = luminance(point.color("specularReflectance"));
  return diffuse + specular > 0.0 ? specular / (diffuse + specular) : 0.0;
}

/// cos^n of the angle to the mirrored direction.
double power(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  const double cosine = glm::dot(mirrored(wi, point.normal), wo);
  return cosine > 0.0 ? std::pow(cosine, point.real("shininess")) : 0.0;
}

}  // namespace

/// A diffuse part and a lobe around the mirrored direction (Lafortune and Willems, 1994), scaled
/// down where they would reflect more than arrives.
glm::dvec3 phongEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return glm::dvec3(0.0);
  const glm::dvec3 kd = point.color("diffuseReflectance"), ks = point.color("specularReflectance");
  const glm::dvec3 sum = kd + ks;
  const double most = std::max({sum.x, sum.y, sum.z}), scale = most > 1.0 ? 0.99 / most : 1.0;
  const double lobe = (point.real("shininess") + 2.0) / (2.0 * std::numbers::pi);
  return scale * (kd / std::numbers::pi + ks * (lobe * power(point, wi, wo)));
}

double phongPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return 0.0;
  const double lobe = (point.real("shininess") + 1.0) / (2.0 * std::numbers::pi);
  const double share = lobeShare(point);
  return share * lobe * power(point, wi, wo) +
         (1.0 - share) * glm::dot(point.normal, wo) / std::numbers::pi;
}

BsdfSample phongSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const double share = lobeShare(point), rest = (numbers.x - share) / (1.0 - share);
  if (numbers.x >= share) return weighted(point, wi, cosineAround(point.normal, {rest, numbers.y}));
  const glm::dvec3 axis = mirrored(wi, point.normal);
  const Turn turn = turnAround(axis, {numbers.x / share, numbers.y});
  const double cosine = std::pow(turn.u, 1.0 / (point.real("shininess") + 1.0));
  return weighted(point, wi, cosine * axis + std::sqrt(1.0 - cosine * cosine) * turn.across);
}

}  // namespace laver::reference
