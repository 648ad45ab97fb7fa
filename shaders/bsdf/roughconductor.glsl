// A rough conductor by its reflectance at normal incidence (Schlick, "An Inexpensive BRDF Model for
// Physically-based Rendering", 1994).
#include "bsdf/beckmann.glsl"

vec3 roughconductorValue(Material m, Facets f) {
  return (xml_R0 + (1.0 - xml_R0) * schlickOf(f.ch)) * f.specular;
}

vec3 roughconductorEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? light * roughconductorValue(m, f) : vec3(0.0);
}

float roughconductorPdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? f.pdf : 0.0;
}

vec3 roughconductorSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float alpha = roughnessOf(xml_alpha);
  wo = mirroredAt(beckmannNormal(alpha, normal, numbers), wi);
  const Facets f = facetsBetween(alpha, normal, wi, wo);
  return f.above ? roughconductorValue(m, f) * (f.co / f.pdf) : vec3(0.0);
}
