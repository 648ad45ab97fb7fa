#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/facets.h"
#include "reference/openness.h"

namespace laver::reference {

namespace {

/// Of a smooth coat: the share of samples that the specular part gets.
double specularShare(const BsdfPoint& point, double cosine) {
  return fresnel(std::max(cosine, 0.0), point.real("extIOR"), point.real("intIOR"));
}

}  // namespace

/// A rough dielectric coat over a diffuse base (Ashikhmin and Shirley, 2000).
glm::dvec3 roughsubstrateEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return glm::dvec3(0.0);
  const Facets f = facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo);
  const double outside = point.real("extIOR"), inside = point.real("intIOR");
  const double head = std::pow((outside - inside) / (outside + inside), 2.0);
  const auto through = [](double cosine) { return 1.0 - std::pow(1.0 - 0.5 * cosine, 5.0); };
  const glm::dvec3 base = 28.0 / (23.0 * std::numbers::pi) * point.color("kd") * (1.0 - head) *
                          through(f.ci) * through(f.co);
  return base + fresnel(f.ch, outside, inside) * f.specular;
}

double roughsubstratePdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return 0.0;
  const Facets f = facetsBetween(roughness(point.real("alpha")), point.normal, wi, wo);
  const double specular = specularShare(point, f.ci);
  return specular * f.pdf + (1.0 - specular) * f.co / std::numbers::pi;
}

BsdfSample roughsubstrateSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const double specular = specularShare(point, glm::dot(point.normal, wi));
  const double rest = (numbers.x - specular) / (1.0 - specular);
  if (numbers.x >= specular)
    return weighted(point, wi, cosineAround(point.normal, {rest, numbers.y}));
  const glm::dvec3 h =
      facetNormal(roughness(point.real("alpha")), point.normal, {numbers.x / specular, numbers.y});
  return weighted(point, wi, mirrored(wi, h));
}

}  // namespace laver::reference
