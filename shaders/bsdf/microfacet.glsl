// A rough dielectric coat over a diffuse base. The specular part has what the largest channel of the diffuse
// one leaves.
#include "bsdf/beckmann.glsl"
#include "bsdf/fresnel.glsl"

float microfacetSpecular(Material m) {
  return greater(1.0 - greater(xml_kd.r, greater(xml_kd.g, xml_kd.b)), 0.0);
}

vec3 microfacetValue(Material m, Facets f) {
  const float fresnel = dielectricFresnel(f.ch, xml_extIOR, xml_intIOR);
  return xml_kd * 0.31830989 + microfacetSpecular(m) * fresnel * f.specular;
}

float microfacetDensity(Material m, Facets f) {
  const float ks = microfacetSpecular(m);
  return ks * f.pdf + (1.0 - ks) * f.co * 0.31830989;
}

vec3 microfacetEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? light * microfacetValue(m, f) : vec3(0.0);
}

float microfacetPdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? microfacetDensity(m, f) : 0.0;
}

vec3 microfacetSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float ks = microfacetSpecular(m), alpha = roughnessOf(xml_alpha);
  if (numbers.x < ks)
    wo = mirroredAt(beckmannNormal(alpha, normal, vec2(numbers.x / ks, numbers.y)), wi);
  else
    wo = cosineDirection(normal, vec2((numbers.x - ks) / (1.0 - ks), numbers.y));
  const Facets f = facetsBetween(alpha, normal, wi, wo);
  return f.above ? microfacetValue(m, f) * (f.co / microfacetDensity(m, f)) : vec3(0.0);
}
