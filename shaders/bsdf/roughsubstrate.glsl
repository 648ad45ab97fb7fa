// A rough dielectric coat over a diffuse base that gets what the coat lets through (Ashikhmin and Shirley,
// "An Anisotropic Phong BRDF Model", 2000).
#include "bsdf/beckmann.glsl"
#include "bsdf/fresnel.glsl"

vec3 roughsubstrateValue(Material m, Facets f) {
  const float r = (xml_extIOR - xml_intIOR) / (xml_extIOR + xml_intIOR);
  const float through = (1.0 - schlickOf(0.5 * f.ci)) * (1.0 - schlickOf(0.5 * f.co));
  const vec3 base = xml_kd * (0.38750768 * (1.0 - r * r) * through);  // 28 / (23 pi)
  return base + dielectricFresnel(f.ch, xml_extIOR, xml_intIOR) * f.specular;
}

// The specular part is chosen by the reflectance of a smooth coat.
float roughsubstrateDensity(Material m, Facets f) {
  const float specular = dielectricFresnel(f.ci, xml_extIOR, xml_intIOR);
  return specular * f.pdf + (1.0 - specular) * f.co * 0.31830989;
}

vec3 roughsubstrateEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? light * roughsubstrateValue(m, f) : vec3(0.0);
}

float roughsubstratePdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? roughsubstrateDensity(m, f) : 0.0;
}

vec3 roughsubstrateSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float alpha = roughnessOf(xml_alpha);
  const float specular =
      dielectricFresnel(greater(dotProduct(normal, wi), 0.0), xml_extIOR, xml_intIOR);
  if (numbers.x < specular)
    wo = mirroredAt(beckmannNormal(alpha, normal, vec2(numbers.x / specular, numbers.y)), wi);
  else
    wo = cosineDirection(normal, vec2((numbers.x - specular) / (1.0 - specular), numbers.y));
  const Facets f = facetsBetween(alpha, normal, wi, wo);
  return f.above ? roughsubstrateValue(m, f) * (f.co / roughsubstrateDensity(m, f)) : vec3(0.0);
}
