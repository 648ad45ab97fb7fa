// A smooth boundary between two dielectrics, reflecting and refracting on both sides: a delta distribution.
// The normal points to the side of extIOR.
#include "bsdf/fresnel.glsl"

vec3 dielectricEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) { return vec3(0.0); }

float dielectricPdf(Material m, vec3 normal, vec3 wi, vec3 wo) { return 0.0; }

// Reflects with a probability equal to the reflectance. Refracted radiance grows by the square of the ratio
// of the indices, since its solid angle shrinks.
vec3 dielectricSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float cosine = dotProduct(normal, wi);
  const float c1 = abs(cosine);
  const float eta = cosine > 0.0 ? xml_extIOR / xml_intIOR : xml_intIOR / xml_extIOR;
  const float c2Squared = 1.0 - eta * eta * (1.0 - c1 * c1);
  const float c2 = sqrt(greater(c2Squared, 0.0));
  const float same = xml_intIOR == xml_extIOR ? 0.0 : fresnelOf(eta, c1, c2);
  const float reflectance = c2Squared < 0.0 ? 1.0 : same;
  const bool reflects = numbers.x < reflectance;
  const vec3 towards = cosine > 0.0 ? normal : -normal;
  wo = reflects ? towards * (2.0 * c1) - wi : towards * (eta * c1 - c2) - wi * eta;
  return vec3(reflects ? 1.0 : eta * eta);
}
