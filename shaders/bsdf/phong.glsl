// A diffuse part and a lobe around the mirrored direction (Lafortune and Willems, "Using the Modified Phong
// Reflectance Model for Physically Based Rendering", 1994).
#include "bsdf/log.glsl"
#include "shared/direction.h"

// What both parts are scaled by, so that they reflect less than arrives.
float phongScale(Material m) {
  const vec3 sum = xml_diffuseReflectance + xml_specularReflectance;
  const float most = greater(sum.r, greater(sum.g, sum.b));
  return most > 1.0 ? 0.99 / most : 1.0;
}

// The share of samples that the lobe gets.
float phongLobe(Material m) {
  const float diffuse = luminanceOf(xml_diffuseReflectance);
  const float specular = luminanceOf(xml_specularReflectance);
  return diffuse + specular > 0.0 ? specular / (diffuse + specular) : 0.0;
}

// The cosine to the mirrored direction, to the power of the shininess; 0 on the other side.
float phongPower(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const vec3 mirrored = normal * (2.0 * dotProduct(normal, wi)) - wi;
  const float cosine = dotProduct(mirrored, wo);
  if (!(cosine > 0.0)) return 0.0;
  const vec3 across = wo - mirrored * cosine;
  const float sine2 = dotProduct(across, across);
  // Near the middle ln cos^2 = ln(1 - sin^2), of which the sine has more digits.
  const float twice = sine2 < 0.03125 ? -sine2 * (1.0 + sine2 * (0.5 + sine2 * (1.0 / 3.0 + sine2 * 0.25)))
                                      : 2.0 * logOf(cosine);
  const float exponent = 0.5 * xml_shininess * twice;
  return exponent < -87.0 ? 0.0 : expOf(exponent);
}

vec3 phongEval(Material m, vec3 normal, vec3 towardsI, vec3 towardsO, vec3 light) {
  const vec3 wi = unitOr(towardsI, normal), wo = unitOr(towardsO, normal);
  if (!(dotProduct(normal, wi) > 0.0 && dotProduct(normal, wo) > 0.0)) return vec3(0.0);
  const float lobe = (xml_shininess + 2.0) * 0.15915494 * phongPower(m, normal, wi, wo);
  return light * phongScale(m) *
         (xml_diffuseReflectance * 0.31830989 + xml_specularReflectance * lobe);
}

float phongPdf(Material m, vec3 normal, vec3 towardsI, vec3 towardsO) {
  const vec3 wi = unitOr(towardsI, normal), wo = unitOr(towardsO, normal);
  const float cosine = dotProduct(normal, wo);
  if (!(dotProduct(normal, wi) > 0.0 && cosine > 0.0)) return 0.0;
  const float lobe = (xml_shininess + 1.0) * 0.15915494 * phongPower(m, normal, wi, wo);
  const float share = phongLobe(m);
  return share * lobe + (1.0 - share) * cosine * 0.31830989;
}

// Around the mirrored direction as beckmannNormal() does around the normal: cos^(n + 1) is uniform.
vec3 phongDirection(Material m, vec3 mirrored, vec2 numbers) {
  const vec3 d = sphereDirection(numbers);
  const float z = dotProduct(mirrored, d);
  const vec3 across = d - mirrored * z;
  const float sine2 = dotProduct(across, across);
  const float u = z < 0.0 ? 0.5 * sine2 / (1.0 - z) : 0.5 + 0.5 * z;
  const float x = -logOf(greater(u, 1e-30)) / (xml_shininess + 1.0);
  const float squared = oneMinusExp(2.0 * greater(x, 0.0));  // sine^2
  if (!(sine2 > 1e-14)) return mirrored;
  return unitOr(mirrored * sqrt(1.0 - squared) + across * sqrt(squared / sine2), mirrored);
}

vec3 phongSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float share = phongLobe(m);
  if (numbers.x < share)
    wo = phongDirection(m, normal * (2.0 * dotProduct(normal, wi)) - wi,
                        vec2(numbers.x / share, numbers.y));
  else
    wo = cosineDirection(normal, vec2((numbers.x - share) / (1.0 - share), numbers.y));
  const float pdf = phongPdf(m, normal, wi, wo);
  return pdf > 0.0 ? phongEval(m, normal, wi, wo, vec3(dotProduct(normal, wo) / pdf)) : vec3(0.0);
}
