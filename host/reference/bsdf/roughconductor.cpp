#include <cmath>

#include "reference/facets.h"

namespace laver::reference {

/// A rough conductor, its reflectance by Schlick (1994).
glm::dvec3 roughconductorEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return glm::dvec3(0.0);
  const Facets f = facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo);
  const glm::dvec3 head = point.color("R0");
  return (head + (1.0 - head) * std::pow(1.0 - f.ch, 5.0)) * f.specular;
}

double roughconductorPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return 0.0;
  return facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo).pdf;
}

BsdfSample roughconductorSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const double alpha = roughness(point.real("alpha"));
  return weighted(point, wi, mirrored(wi, facetNormal(alpha, point.normal, numbers)));
}

}  // namespace laver::reference
