#include "reference/facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace laver::reference {

Turn turnAround(glm::dvec3 axis, glm::dvec2 numbers) {
  const double z = 1.0 - 2.0 * numbers.x, azimuth = 2.0 * std::numbers::pi * numbers.y;
  const double r = std::sqrt(1.0 - z * z);
  const glm::dvec3 d(r * std::cos(azimuth), r * std::sin(azimuth), z);
  const glm::dvec3 across = d - glm::dot(axis, d) * axis;
  const double length = glm::length(across);
  return {0.5 + 0.5 * glm::dot(axis, d), length > 0.0 ? across / length : glm::dvec3(0.0)};
}

glm::dvec3 tilted(glm::dvec3 axis, const Turn& turn, double squaredTangent) {
  return glm::normalize(axis + std::sqrt(squaredTangent) * turn.across);
}

double roughness(double alpha) { return std::max(alpha, 1e-3); }

double beckmann(double alpha, double cosine) {
  if (cosine <= 0.0) return 0.0;
  const double tangent2 = (1.0 - cosine * cosine) / (cosine * cosine);
  return std::exp(-tangent2 / (alpha * alpha)) /
         (std::numbers::pi * alpha * alpha * std::pow(cosine, 4.0));
}

double shadowing(double alpha, double cosine) {
  const double tangent = std::tan(std::acos(std::min(std::abs(cosine), 1.0)));
  if (alpha * tangent <= 1.0 / 1.6) return 1.0;
  const double b = 1.0 / (alpha * tangent);
  return (3.535 * b + 2.181 * b * b) / (1.0 + 2.276 * b + 2.577 * b * b);
}

glm::dvec3 facetNormal(double alpha, glm::dvec3 normal, glm::dvec2 numbers) {
  const Turn turn = turnAround(normal, numbers);
  return tilted(normal, turn, -alpha * alpha * std::log(std::max(turn.u, 1e-30)));
}

glm::dvec3 mirrored(glm::dvec3 wi, glm::dvec3 normal) {
  return 2.0 * glm::dot(wi, normal) * normal - wi;
}

bool bothAbove(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  return glm::dot(point.normal, wi) > 0.0 && glm::dot(point.normal, wo) > 0.0;
}

Facets facetsBetween(double alpha, glm::dvec3 normal, glm::dvec3 wi, glm::dvec3 wo) {
  const glm::dvec3 h = glm::normalize(wi + wo);
  Facets f{};
  f.ci = glm::dot(normal, wi);
  f.co = glm::dot(normal, wo);
  f.ch = glm::dot(h, wo);
  // Of two directions above, h lies between them: both see the facet's front.
  const double density = beckmann(alpha, glm::dot(normal, h));
  f.specular = density * shadowing(alpha, f.ci) * shadowing(alpha, f.co) / (4.0 * f.ci * f.co);
  f.pdf = density * glm::dot(normal, h) / (4.0 * f.ch);
  return f;
}

BsdfSample weighted(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  const double pdf = point.bsdf.row->pdf(point, wi, wo);
  if (!(pdf > 0.0)) return {wo, glm::dvec3(0.0)};
  const double cosine = std::abs(glm::dot(point.normal, wo));
  return {wo, point.bsdf.row->eval(point, wi, wo) * (cosine / pdf)};
}

glm::dvec3 conductorFresnel(double cosine, glm::dvec3 eta, glm::dvec3 k) {
  const glm::dvec3 t = eta * eta + k * k, c(cosine), c2(cosine * cosine), one(1.0);
  const glm::dvec3 parallel = (t * c2 - 2.0 * eta * c + one) / (t * c2 + 2.0 * eta * c + one);
  const glm::dvec3 perpendicular = (t - 2.0 * eta * c + c2) / (t + 2.0 * eta * c + c2);
  return 0.5 * (parallel + perpendicular);
}

}  // namespace laver::reference
