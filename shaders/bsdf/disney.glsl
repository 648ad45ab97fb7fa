// Burley's "principled" BRDF ("Physically Based Shading at Disney", 2012): a diffuse and a sheen part, a
// specular one and a clear coat.
#include "bsdf/log.glsl"
#include "shared/direction.h"

// The roughness of the specular part, of the coat's distribution, and of the coat's shadowing.
float disneyAlpha(Material m) { return greater(xml_roughness * xml_roughness, 1e-3); }
float disneyCoatAlpha(Material m) { return mix(0.1, 0.001, xml_clearcoatGloss); }
const float DISNEY_COAT_SHADOWING = 0.25;

// Two directions on the upper side, and their half vector.
struct Halves {
  bool above;
  float ci, co;    // cosines to the normal
  float ch;        // of either to h
  float hn;        // of h to the normal
  float h2;        // the square of the sine between h and the normal
  float i2, o2;    // the same of wi and wo
};

float disneySquaredSine(vec3 normal, vec3 v, float cosine) {
  const vec3 across = v - normal * cosine;
  return dotProduct(across, across);
}

Halves halvesOf(vec3 normal, vec3 towardsI, vec3 towardsO) {
  const vec3 wi = unitOr(towardsI, normal), wo = unitOr(towardsO, normal);
  const vec3 h = unitOr(wi + wo, normal);
  Halves d;
  d.ci = dotProduct(normal, wi);
  d.co = dotProduct(normal, wo);
  d.ch = dotProduct(h, wo);
  d.hn = dotProduct(h, normal);
  d.h2 = disneySquaredSine(normal, h, d.hn);
  d.i2 = disneySquaredSine(normal, wi, d.ci);
  d.o2 = disneySquaredSine(normal, wo, d.co);
  d.above = d.ci > 0.0 && d.co > 0.0;
  return d;
}

// Generalised Trowbridge and Reitz's distributions, with the exponents 2 and 1.
float disneySpecularDensity(float alpha, Halves d) {
  const float t = d.h2 / (alpha * alpha) + d.hn * d.hn;
  return 0.31830989 / (alpha * alpha * t * t);
}
float disneyCoatDensity(float alpha, Halves d) {
  const float a2 = alpha * alpha;
  return (1.0 - a2) * 0.31830989 / (-logOf(a2) * (d.h2 + a2 * d.hn * d.hn));
}

float disneyShadowing(float alpha, float cosine, float sine2) {
  return 2.0 / (1.0 + sqrt(1.0 + alpha * alpha * sine2 / (cosine * cosine)));
}

vec3 disneyDiffuse(Material m, Halves d, vec3 tint) {
  const float grazing = xml_roughness * d.ch * d.ch;
  const float fi = schlickOf(d.ci), fo = schlickOf(d.co);
  const float diffuse = mix(1.0, 0.5 + 2.0 * grazing, fo) * mix(1.0, 0.5 + 2.0 * grazing, fi);
  const float scattered = mix(1.0, grazing, fo) * mix(1.0, grazing, fi);
  const float below = 1.25 * (scattered * (1.0 / (d.ci + d.co) - 0.5) + 0.5);
  const vec3 sheen = mix(vec3(1.0), tint, xml_sheenTint) * (xml_sheen * schlickOf(d.ch));
  return xml_baseColor * (mix(diffuse, below, xml_subsurface) * 0.31830989) + sheen;
}

vec3 disneyValue(Material m, Halves d) {
  const float luminance = luminanceOf(xml_baseColor);
  const vec3 tint = luminance > 0.0 ? xml_baseColor / luminance : vec3(1.0);
  const vec3 dielectric = mix(vec3(1.0), tint, xml_specularTint) * (0.08 * xml_specular);
  const vec3 head = mix(dielectric, xml_baseColor, xml_metallic);
  const float alpha = disneyAlpha(m), grazing = schlickOf(d.ch), both = 4.0 * d.ci * d.co;
  const vec3 specular = (head + (1.0 - head) * grazing) *
                        (disneySpecularDensity(alpha, d) * disneyShadowing(alpha, d.ci, d.i2) *
                         disneyShadowing(alpha, d.co, d.o2) / both);
  const float coat = 0.25 * xml_clearcoat * disneyCoatDensity(disneyCoatAlpha(m), d) *
                     mix(0.04, 1.0, grazing) * disneyShadowing(DISNEY_COAT_SHADOWING, d.ci, d.i2) *
                     disneyShadowing(DISNEY_COAT_SHADOWING, d.co, d.o2) / both;
  return disneyDiffuse(m, d, tint) * (1.0 - xml_metallic) + specular + coat;
}

// Shares of samples: diffuse, specular, coat.
vec3 disneyShares(Material m) {
  const vec3 shares = vec3(1.0 - xml_metallic, 1.0, 0.25 * xml_clearcoat);
  return shares / (shares.x + shares.y + shares.z);
}

float disneyDensity(Material m, Halves d) {
  const vec3 shares = disneyShares(m);
  const float facets = shares.y * disneySpecularDensity(disneyAlpha(m), d) +
                       shares.z * disneyCoatDensity(disneyCoatAlpha(m), d);
  return shares.x * d.co * 0.31830989 + facets * d.hn / (4.0 * d.ch);
}

vec3 disneyEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  const Halves d = halvesOf(normal, wi, wo);
  return d.above ? light * disneyValue(m, d) : vec3(0.0);
}

float disneyPdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const Halves d = halvesOf(normal, wi, wo);
  return d.above ? disneyDensity(m, d) : 0.0;
}

// A normal with the density of the coat times its cosine, by a uniform direction on the sphere as in
// bsdf/beckmann.glsl: sine^2 = (a^2u - a^2) / (1 - a^2).
vec3 disneyCoatNormal(float alpha, vec3 normal, vec3 across, float sine2, float u) {
  const float a2 = alpha * alpha, power = -logOf(a2);
  const float squared = a2 * (expOf(power * (1.0 - u)) - 1.0) / (1.0 - a2);
  if (!(sine2 > 1e-14)) return normal;
  return unitOr(normal * sqrt(greater(1.0 - squared, 0.0)) + across * sqrt(squared / sine2), normal);
}

vec3 disneyNormal(Material m, vec3 normal, bool coat, vec2 numbers) {
  const vec3 d = sphereDirection(numbers);
  const float z = dotProduct(normal, d);
  const vec3 across = d - normal * z;
  const float sine2 = dotProduct(across, across);
  const float twice = z < 0.0 ? sine2 / (1.0 - z) : 1.0 + z;  // 2 u
  if (coat) return disneyCoatNormal(disneyCoatAlpha(m), normal, across, sine2, 0.5 * twice);
  // tan^2 = alpha^2 (1 - u) / u: the tangent of half the angle to d, times alpha.
  return unitOr(normal * twice + across * disneyAlpha(m), normal);
}

vec3 disneySample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const vec3 shares = disneyShares(m);
  const bool coat = numbers.x >= shares.x + shares.y;
  const float before = coat ? shares.x + shares.y : shares.x;
  const float rest = lesser((numbers.x - before) / (coat ? shares.z : shares.y), 1.0);
  if (numbers.x < shares.x) {
    wo = cosineDirection(normal, vec2(numbers.x / shares.x, numbers.y));
  } else {
    const vec3 h = disneyNormal(m, normal, coat, vec2(rest, numbers.y));
    wo = h * (2.0 * dotProduct(h, wi)) - wi;
  }
  const Halves d = halvesOf(normal, wi, wo);
  return d.above ? disneyValue(m, d) * (d.co / disneyDensity(m, d)) : vec3(0.0);
}
