#include <algorithm>
#include <numbers>

#include "reference/facets.h"
#include "reference/openness.h"

namespace laver::reference {

namespace {

double specularShare(const BsdfPoint& point) {
  const glm::dvec3 kd = point.color("kd");
  return std::max(1.0 - std::max({kd.x, kd.y, kd.z}), 0.0);
}

}  // namespace

/// A rough dielectric coat over a diffuse base, which leaves the specular part what the largest of
/// its channels does not reflect.
glm::dvec3 microfacetEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return glm::dvec3(0.0);
  const Facets f = facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo);
  const double specular = fresnel(f.ch, point.real("extIOR"), point.real("intIOR")) * f.specular;
  return point.color("kd") / std::numbers::pi + specularShare(point) * specular;
}

double microfacetPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return 0.0;
  const Facets f = facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo);
  const double ks = specularShare(point);
  return ks * f.pdf + (1.0 - ks) * f.co / std::numbers::pi;
}

BsdfSample microfacetSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const double ks = specularShare(point);
  if (numbers.x >= ks)
    return weighted(point, wi,
                    cosineAround(point.normal, {(numbers.x - ks) / (1.0 - ks), numbers.y}));
  const double alpha = roughness(point.real("alpha"));
  return weighted(point, wi,
                  mirrored(wi, facetNormal(alpha, point.normal, {numbers.x / ks, numbers.y})));
}

}  // namespace laver::reference
