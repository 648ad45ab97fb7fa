#include <cmath>

#include "reference/facets.h"

namespace laver::reference {

namespace {

/// The boundary as wi sees it.
struct Side {
  glm::dvec3 normal;
  double here, beyond;  ///< indices of refraction
};

Side sideOf(const BsdfPoint& point, glm::dvec3 wi) {
  const double outside = point.real("extIOR"), inside = point.real("intIOR");
  if (glm::dot(point.normal, wi) > 0.0) return {point.normal, outside, inside};
  return {-point.normal, inside, outside};
}

double reflecting(const Side& side, glm::dvec3 wi) {
  return 0.05 + 0.9 * fresnel(glm::dot(side.normal, wi), side.here, side.beyond);
}

struct Lobes {
  double value = 0.0, pdf = 0.0;
};

/// The BSDF and the density of samples.
Lobes lobesOf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  const Side side = sideOf(point, wi);
  const double ci = glm::dot(side.normal, wi), co = glm::dot(side.normal, wo);
  if (ci <= 0.0 || co == 0.0) return {};
  const bool reflects = co > 0.0;
  glm::dvec3 h = glm::normalize(reflects ? wi + wo : -(side.here * wi + side.beyond * wo));
  if (glm::dot(h, side.normal) < 0.0) h = -h;
  const double hi = glm::dot(h, wi), ho = glm::dot(h, wo), hn = glm::dot(h, side.normal);
  if (hi <= 0.0 || ho * co <= 0.0) return {};
  const double alpha = roughness(point.real("alpha")), density = beckmann(alpha, hn);
  const double shown = density * shadowing(alpha, ci) * shadowing(alpha, co);
  const double f = fresnel(hi, side.here, side.beyond), chosen = reflecting(side, wi);
  if (reflects) return {shown * f / (4.0 * ci * co), chosen * density * hn / (4.0 * ho)};
  // Walter and others, "Microfacet Models for Refraction through Rough Surfaces", 2007, (16) to
  // (21), where light goes from wo to wi.
  const double jacobian = 1.0 / std::pow(side.here * hi + side.beyond * ho, 2.0);
  return {hi * -ho / (ci * -co) * side.here * side.here * (1.0 - f) * shown * jacobian,
          (1.0 - chosen) * density * hn * side.beyond * side.beyond * -ho * jacobian};
}

}  // namespace

/// A rough boundary between two dielectrics, of both sides.
glm::dvec3 microfacetDielectricEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  return glm::dvec3(lobesOf(point, wi, wo).value);
}

double microfacetDielectricPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  return lobesOf(point, wi, wo).pdf;
}

BsdfSample microfacetDielectricSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const Side side = sideOf(point, wi);
  const double chosen = reflecting(side, wi), alpha = roughness(point.real("alpha"));
  const bool reflects = numbers.x < chosen;
  const double rest = reflects ? numbers.x / chosen : (numbers.x - chosen) / (1.0 - chosen);
  const glm::dvec3 h = facetNormal(alpha, side.normal, {rest, numbers.y});
  const double hi = glm::dot(h, wi), eta = side.here / side.beyond;
  const double c2 = 1.0 - eta * eta * (1.0 - hi * hi);
  const glm::dvec3 wo =
      reflects ? mirrored(wi, h) : h * (eta * hi - std::sqrt(std::max(c2, 0.0))) - eta * wi;
  const bool none = hi <= 0.0 || (!reflects && c2 <= 0.0);
  if (none || reflects != (glm::dot(side.normal, wo) > 0.0)) return {wo, glm::dvec3(0.0)};
  return weighted(point, wi, wo);
}

}  // namespace laver::reference
