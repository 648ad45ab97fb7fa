// Burley's "principled" BRDF ("Physically Based Shading at Disney", 2012): a diffuse and a sheen part, a
// specular one and a clear coat.
#include "bsdf/frame.glsl"
#include "bsdf/log.glsl"
#include "shared/direction.h"

// The roughness of the specular part along and across the tangent, of the coat's distribution, and of the coat's
// shadowing.
vec2 disneyAlphas(Material m) {
  const float alpha = xml_roughness * xml_roughness;
  const float aspect = HAS_TANGENTS ? sqrt(1.0 - 0.9 * xml_anisotropic) : 1.0;
  return vec2(greater(alpha / aspect, 1e-3), greater(alpha * aspect, 1e-3));
}
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
  float hOver;     // h2 with each component over its alpha
  float iTimes, oTimes;  // the others, each component times its alpha
};

float disneySquaredSine(vec3 normal, vec3 v, float cosine) {
  const vec3 across = v - normal * cosine;
  return dotProduct(across, across);
}

// The squared length of what v has across the normal, whose squared length is `sine2`, each component times its
// factor.
float disneyStretched(Material m, vec3 normal, vec3 v, float sine2, vec2 factors) {
  if (!HAS_TANGENTS) return factors.x * factors.x * sine2;
  const vec3 x = frameX(normal, m.tangent);
  const vec2 stretched = vec2(dotProduct(v, x), dotProduct(v, crossProduct(normal, x))) * factors;
  return dot(stretched, stretched);
}

Halves halvesOf(Material m, vec3 normal, vec3 towardsI, vec3 towardsO) {
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
  const vec2 alphas = disneyAlphas(m);
  d.hOver = disneyStretched(m, normal, h, d.h2, 1.0 / alphas);
  d.iTimes = disneyStretched(m, normal, wi, d.i2, alphas);
  d.oTimes = disneyStretched(m, normal, wo, d.o2, alphas);
  d.above = d.ci > 0.0 && d.co > 0.0;
  return d;
}

// Generalised Trowbridge and Reitz's distributions, with the exponents 2 and 1.
float disneySpecularDensity(vec2 alphas, Halves d) {
  const float t = d.hOver + d.hn * d.hn;
  return 0.31830989 / (alphas.x * alphas.y * t * t);
}
float disneyCoatDensity(float alpha, Halves d) {
  const float a2 = alpha * alpha;
  return (1.0 - a2) * 0.31830989 / (-logOf(a2) * (d.h2 + a2 * d.hn * d.hn));
}

// `sine2`: the squared sine of a direction, each component times its alpha.
float disneyShadowing(float cosine, float sine2) {
  return 2.0 / (1.0 + sqrt(1.0 + sine2 / (cosine * cosine)));
}
float disneyCoatShadowing(float cosine, float sine2) {
  return disneyShadowing(cosine, DISNEY_COAT_SHADOWING * DISNEY_COAT_SHADOWING * sine2);
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
  const float grazing = schlickOf(d.ch), both = 4.0 * d.ci * d.co;
  const vec3 specular = (head + (1.0 - head) * grazing) *
                        (disneySpecularDensity(disneyAlphas(m), d) * disneyShadowing(d.ci, d.iTimes) *
                         disneyShadowing(d.co, d.oTimes) / both);
  const float coat = 0.25 * xml_clearcoat * disneyCoatDensity(disneyCoatAlpha(m), d) *
                     mix(0.04, 1.0, grazing) * disneyCoatShadowing(d.ci, d.i2) *
                     disneyCoatShadowing(d.co, d.o2) / both;
  return disneyDiffuse(m, d, tint) * (1.0 - xml_metallic) + specular + coat;
}

// Shares of samples: diffuse, specular, coat.
vec3 disneyShares(Material m) {
  const vec3 shares = vec3(1.0 - xml_metallic, 1.0, 0.25 * xml_clearcoat);
  return shares / (shares.x + shares.y + shares.z);
}

float disneyDensity(Material m, Halves d) {
  const vec3 shares = disneyShares(m);
  const float facets = shares.y * disneySpecularDensity(disneyAlphas(m), d) +
                       shares.z * disneyCoatDensity(disneyCoatAlpha(m), d);
  return shares.x * d.co * 0.31830989 + facets * d.hn / (4.0 * d.ch);
}

vec3 disneyEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  const Halves d = halvesOf(m, normal, wi, wo);
  return d.above ? light * disneyValue(m, d) : vec3(0.0);
}

float disneyPdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const Halves d = halvesOf(m, normal, wi, wo);
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
  // tan^2 = alpha^2 (1 - u) / u: the tangent of half the angle to d, times alpha, component by component.
  const vec2 alphas = disneyAlphas(m);
  if (!HAS_TANGENTS) return unitOr(normal * twice + across * alphas.x, normal);
  const vec3 x = frameX(normal, m.tangent), y = crossProduct(normal, x);
  return unitOr(normal * twice + x * (dotProduct(across, x) * alphas.x) +
                    y * (dotProduct(across, y) * alphas.y),
                normal);
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
  const Halves d = halvesOf(m, normal, wi, wo);
  return d.above ? disneyValue(m, d) * (d.co / disneyDensity(m, d)) : vec3(0.0);
}
