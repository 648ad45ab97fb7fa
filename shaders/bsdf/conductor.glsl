// A smooth conductor on the upper side: a delta distribution.
#include "bsdf/fresnel.glsl"

vec3 conductorEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) { return vec3(0.0); }

float conductorPdf(Material m, vec3 normal, vec3 wi, vec3 wo) { return 0.0; }

vec3 conductorSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float cosine = dotProduct(normal, wi);
  wo = normal * (2.0 * cosine) - wi;
  return cosine > 0.0 ? xml_specularReflectance * conductorFresnel(cosine, xml_eta, xml_k) : vec3(0.0);
}
