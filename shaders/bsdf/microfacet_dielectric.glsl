// A rough boundary between two dielectrics, of both sides (Walter and others, "Microfacet Models for
// Refraction through Rough Surfaces", 2007). The normal points to the side of extIOR.
#include "bsdf/beckmann.glsl"
#include "bsdf/fresnel.glsl"

// Two directions and what the facets between them do: a reflection if they are on one side.
struct RoughBoundary {
  float value;    // the BSDF
  float pdf;      // of wo, if h is drawn by beckmannNormal() and light is reflected with `reflecting`
  float co;       // |cosine| of wo
};

// Light is reflected with this probability: about as often as at a smooth boundary, and never surely, since
// single facets refract where the whole surface would not.
float microfacet_dielectricReflecting(float cosine, float here, float beyond) {
  return 0.05 + 0.9 * dielectricFresnel(cosine, here, beyond);
}

// `normal` on the side of wi, whose index is `here`.
RoughBoundary roughBoundary(float alpha, vec3 normal, vec3 wi, vec3 wo, float here, float beyond) {
  const float ci = dotProduct(normal, wi), co = dotProduct(normal, wo);
  const bool reflects = co > 0.0;
  const vec3 across = reflects ? wi + wo : -(wi * here + wo * beyond);
  vec3 h = unitOr(across, normal);
  h = dotProduct(h, normal) < 0.0 ? -h : h;
  const float hi = dotProduct(h, wi), ho = dotProduct(h, wo);
  RoughBoundary b;
  b.co = abs(co);
  b.value = b.pdf = 0.0;
  // A facet is seen from the side from which the surface is.
  if (!(hi > 0.0) || ho * co <= 0.0 || co == 0.0 || ci <= 0.0) return b;
  const float density = beckmannDensity(alpha, normal, h);
  const float fresnel = dielectricFresnel(hi, here, beyond);
  const float reflecting = microfacet_dielectricReflecting(ci, here, beyond);
  const float both = density * beckmannShadowing(alpha, normal, wi, h) *
                     beckmannShadowing(alpha, normal, wo, h) / (ci * b.co);
  const float drawn = density * dotProduct(h, normal);
  if (reflects) {
    b.value = both * fresnel * 0.25;
    b.pdf = reflecting * drawn / (4.0 * ho);
  } else {
    const float sum = here * hi + beyond * ho;
    const float spread = abs(ho) / (sum * sum);
    b.value = both * (1.0 - fresnel) * hi * here * here * spread;
    b.pdf = (1.0 - reflecting) * drawn * beyond * beyond * spread;
  }
  return b;
}

// Seen from the side of wi.
RoughBoundary microfacet_dielectricAt(Material m, vec3 normal, vec3 towardsI, vec3 towardsO) {
  const vec3 wi = unitOr(towardsI, normal), wo = unitOr(towardsO, normal);
  const bool above = dotProduct(normal, wi) > 0.0;
  return roughBoundary(roughnessOf(xml_alpha), above ? normal : -normal, wi, wo,
                       above ? xml_extIOR : xml_intIOR, above ? xml_intIOR : xml_extIOR);
}

vec3 microfacet_dielectricEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  return light * microfacet_dielectricAt(m, normal, wi, wo).value;
}

float microfacet_dielectricPdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  return microfacet_dielectricAt(m, normal, wi, wo).pdf;
}

vec3 microfacet_dielectricSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const bool above = dotProduct(normal, wi) > 0.0;
  const vec3 side = above ? normal : -normal;
  const float here = above ? xml_extIOR : xml_intIOR, beyond = above ? xml_intIOR : xml_extIOR;
  const float reflecting = microfacet_dielectricReflecting(dotProduct(side, wi), here, beyond);
  const bool reflects = numbers.x < reflecting;
  const float rest = reflects ? numbers.x / reflecting
                              : (numbers.x - reflecting) / (1.0 - reflecting);
  const vec3 h = beckmannNormal(roughnessOf(xml_alpha), side, vec2(rest, numbers.y));
  const float hi = dotProduct(h, wi), eta = here / beyond;
  const float c2Squared = 1.0 - eta * eta * (1.0 - hi * hi);
  wo = reflects ? mirroredAt(h, wi) : h * (eta * hi - sqrt(greater(c2Squared, 0.0))) - wi * eta;
  if (!(hi > 0.0) || (!reflects && c2Squared <= 0.0)) return vec3(0.0);
  const RoughBoundary b = microfacet_dielectricAt(m, normal, wi, wo);
  // A direction that left the other side of the surface than its lobe is none of its samples.
  if (!(b.pdf > 0.0) || reflects != (dotProduct(side, wo) > 0.0)) return vec3(0.0);
  return vec3(b.value * b.co / b.pdf);
}
