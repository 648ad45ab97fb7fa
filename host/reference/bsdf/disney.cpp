#include <cmath>
#include <numbers>

#include "reference/facets.h"
#include "reference/openness.h"

namespace laver::reference {

namespace {

template <class T>
T blend(T a, T b, double t) {
  return a + t * (b - a);
}

double schlick(double cosine) { return std::pow(1.0 - cosine, 5.0); }

/// The frame of the specular part, and its roughness along x and y.
struct Facet {
  glm::dvec3 x, y, n;
  double alphaX, alphaY;

  explicit Facet(const BsdfPoint& point)
      : x(frameX(point.normal, point.along)), y(glm::cross(point.normal, x)), n(point.normal) {
    const double alpha = std::pow(point.real("roughness"), 2.0);
    const double aspect = std::sqrt(1.0 - 0.9 * point.real("anisotropic"));
    alphaX = std::max(0.001, alpha / aspect);
    alphaY = std::max(0.001, alpha * aspect);
  }

  /// The distribution of Trowbridge and Reitz.
  double density(glm::dvec3 h) const {
    const double hx = glm::dot(h, x) / alphaX, hy = glm::dot(h, y) / alphaY, hz = glm::dot(h, n);
    return 1.0 / (std::numbers::pi * alphaX * alphaY * std::pow(hx * hx + hy * hy + hz * hz, 2.0));
  }
  double smith(glm::dvec3 w) const {
    const double wx = glm::dot(w, x) * alphaX, wy = glm::dot(w, y) * alphaY, wz = glm::dot(w, n);
    return 1.0 / (1.0 + 0.5 * (std::sqrt(1.0 + (wx * wx + wy * wy) / (wz * wz)) - 1.0));
  }
  /// Drawn with density() * cosine: slopes of an isotropic distribution, stretched.
  glm::dvec3 draw(glm::dvec2 numbers) const {
    const Turn turn = turnAround(n, numbers);
    const double slope = std::sqrt(1.0 / turn.u - 1.0);
    return glm::normalize(n + slope * (alphaX * glm::dot(turn.across, x) * x +
                                       alphaY * glm::dot(turn.across, y) * y));
  }
};

/// Its generalisation with the exponent 1, for the coat.
double coatDensity(double a, double cosine) {
  const double a2 = a * a;
  return (a2 - 1.0) / (std::numbers::pi * std::log(a2) * (1.0 + (a2 - 1.0) * cosine * cosine));
}

double smith(double alpha, double cosine) {
  const double t2 = 1.0 / (cosine * cosine) - 1.0;
  return 1.0 / (1.0 + 0.5 * (std::sqrt(1.0 + t2 * alpha * alpha) - 1.0));
}

double coatAlpha(const BsdfPoint& point) { return blend(0.1, 0.001, point.real("clearcoatGloss")); }

/// Relative frequencies of the parts.
struct Parts {
  double diffuse, specular, coat;
  double sum() const { return diffuse + specular + coat; }
};
Parts partsOf(const BsdfPoint& point) {
  return {1.0 - point.real("metallic"), 1.0, 0.25 * point.real("clearcoat")};
}

/// Cosines of wi and wo to the normal, of both to h, and of h to the normal.
struct Cosines {
  double ci, co, ch, hn;
};
Cosines cosinesOf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  const glm::dvec3 h = glm::normalize(wi + wo);
  return {glm::dot(point.normal, wi), glm::dot(point.normal, wo), glm::dot(h, wo),
          glm::dot(h, point.normal)};
}

glm::dvec3 tintOf(glm::dvec3 color) {
  const double y = luminance(color);
  return y > 0.0 ? color / y : glm::dvec3(1.0);
}

glm::dvec3 diffusePart(const BsdfPoint& point, const Cosines& c) {
  const glm::dvec3 base = point.color("baseColor");
  const double bent = point.real("roughness") * c.ch * c.ch;
  const auto both = [&](double grazing) {
    return blend(1.0, grazing, schlick(c.ci)) * blend(1.0, grazing, schlick(c.co));
  };
  const double below = 1.25 * (both(bent) * (1.0 / (c.ci + c.co) - 0.5) + 0.5);
  const double body = blend(both(0.5 + 2.0 * bent), below, point.real("subsurface"));
  const glm::dvec3 sheen = blend(glm::dvec3(1.0), tintOf(base), point.real("sheenTint"));
  return body / std::numbers::pi * base + schlick(c.ch) * point.real("sheen") * sheen;
}

}  // namespace

/// Burley's "principled" BRDF (2012).
glm::dvec3 disneyEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return glm::dvec3(0.0);
  const Cosines c = cosinesOf(point, wi, wo);
  const glm::dvec3 base = point.color("baseColor"), white(1.0);
  const double metallic = point.real("metallic");
  const Facet facet(point);
  const glm::dvec3 dielectric =
      0.08 * point.real("specular") * blend(white, tintOf(base), point.real("specularTint"));
  const glm::dvec3 f = blend(blend(dielectric, base, metallic), white, schlick(c.ch));
  const double specular = facet.density(glm::normalize(wi + wo)) * facet.smith(wi) *
                          facet.smith(wo) / (4.0 * c.ci * c.co);
  const double coat = 0.25 * point.real("clearcoat") * coatDensity(coatAlpha(point), c.hn) *
                      blend(0.04, 1.0, schlick(c.ch)) * smith(0.25, c.ci) * smith(0.25, c.co) /
                      (4.0 * c.ci * c.co);
  return (1.0 - metallic) * diffusePart(point, c) + specular * f + coat;
}

double disneyPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  if (!bothAbove(point, wi, wo)) return 0.0;
  const Cosines c = cosinesOf(point, wi, wo);
  const Parts parts = partsOf(point);
  const double facets = parts.specular * Facet(point).density(glm::normalize(wi + wo)) +
                        parts.coat * coatDensity(coatAlpha(point), c.hn);
  return (parts.diffuse * c.co / std::numbers::pi + facets * c.hn / (4.0 * c.ch)) / parts.sum();
}

BsdfSample disneySample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const Parts parts = partsOf(point);
  double x = numbers.x * parts.sum();
  if (x < parts.diffuse)
    return weighted(point, wi, cosineAround(point.normal, {x / parts.diffuse, numbers.y}));
  x -= parts.diffuse;
  const bool specular = x < parts.specular;
  const double rest = specular ? x / parts.specular : (x - parts.specular) / parts.coat;
  if (specular) return weighted(point, wi, mirrored(wi, Facet(point).draw({rest, numbers.y})));
  const Turn turn = turnAround(point.normal, {rest, numbers.y});
  const double a2 = std::pow(coatAlpha(point), 2.0);
  const double cosine2 = (1.0 - std::pow(a2, turn.u)) / (1.0 - a2);
  return weighted(point, wi,
                  mirrored(wi, tilted(point.normal, turn, std::max(1.0 / cosine2 - 1.0, 0.0))));
}

}  // namespace laver::reference
