#include <cmath>

#include "reference/bsdf.h"

namespace laver::reference {

/// A smooth boundary between two dielectrics, of both sides: a delta distribution. The normal
/// points to the side of extIOR.
glm::dvec3 dielectricEval(const BsdfPoint&, glm::dvec3, glm::dvec3) { return glm::dvec3(0.0); }

double dielectricPdf(const BsdfPoint&, glm::dvec3, glm::dvec3) { return 0.0; }

/// Reflects with the probability of the reflectance. Refracted radiance grows by the square of the
/// ratio of the indices, since its solid angle shrinks.
BsdfSample dielectricSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const double outside = point.real("extIOR"), inside = point.real("intIOR");
  const double cosine = glm::dot(point.normal, wi);
  if (numbers.x < fresnel(cosine, outside, inside))
    return {2.0 * cosine * point.normal - wi, glm::dvec3(1.0)};
  const double eta = cosine > 0.0 ? outside / inside : inside / outside;
  const double c2 = std::sqrt(1.0 - eta * eta * (1.0 - cosine * cosine));
  const glm::dvec3 normal = cosine > 0.0 ? point.normal : -point.normal;
  return {normal * (eta * std::abs(cosine) - c2) - eta * wi, glm::dvec3(eta * eta)};
}

}  // namespace laver::reference
