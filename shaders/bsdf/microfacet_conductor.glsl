// A rough conductor by its complex index of refraction.
#include "bsdf/beckmann.glsl"
#include "bsdf/fresnel.glsl"

vec3 microfacet_conductorEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? light * conductorFresnel(f.ch, xml_intIOR, xml_intK) * f.specular : vec3(0.0);
}

float microfacet_conductorPdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const Facets f = facetsBetween(roughnessOf(xml_alpha), normal, wi, wo);
  return f.above ? f.pdf : 0.0;
}

vec3 microfacet_conductorSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float alpha = roughnessOf(xml_alpha);
  wo = mirroredAt(beckmannNormal(alpha, normal, numbers), wi);
  const Facets f = facetsBetween(alpha, normal, wi, wo);
  return f.above ? conductorFresnel(f.ch, xml_intIOR, xml_intK) * (f.specular * f.co / f.pdf)
                 : vec3(0.0);
}
