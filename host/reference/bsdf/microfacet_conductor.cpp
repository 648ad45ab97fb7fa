#include "reference/facets.h"

namespace laver::reference {

/// A rough conductor, its reflectance by the complex index of refraction.
glm::dvec3 microfacetConductorEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return glm::dvec3(0.0);
  const Facets f = facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo);
  return conductorFresnel(f.ch, point.color("intIOR"), point.color("intK")) * f.specular;
}

double microfacetConductorPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return 0.0;
  return facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo).pdf;
}

BsdfSample microfacetConductorSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const double alpha = roughness(point.real("alpha"));
  return weighted(point, wi, mirrored(wi, facetNormal(alpha, point.normal, numbers)));
}

}  // namespace laver::reference
