// Reflection by microfacets of Beckmann's distribution, with the roughness alpha (Walter, Marschner, Li and
// Torrance, "Microfacet Models for Refraction through Rough Surfaces", 2007).
#include "bsdf/log.glsl"
#include "shared/direction.h"

// Rougher than this; textures may show less. Below, a direction's own rounding would show.
float roughnessOf(float alpha) { return greater(alpha, 1e-3); }

// The square of the sine of the angle between unit vectors: 1 - cosine^2 would lose digits of small ones.
float squaredSine(vec3 normal, vec3 v, float cosine) {
  const vec3 across = v - normal * cosine;
  return dotProduct(across, across);
}

// Density of the normals h, per solid angle of h and area of the surface.
float beckmannDensity(float alpha, vec3 normal, vec3 h) {
  const float cosine = dotProduct(normal, h);
  if (!(cosine > 0.0)) return 0.0;
  const float c2 = cosine * cosine, a2 = alpha * alpha;
  const float exponent = squaredSine(normal, h, cosine) / (c2 * a2);
  return exponent > 87.0 ? 0.0 : expOf(-exponent) * 0.31830989 / (a2 * c2 * c2);
}

// A normal with the density of beckmannDensity() times its cosine. A direction that is uniform on the sphere
// gives both numbers without a frame of tangents: its height z over the normal is uniform, and so is the
// angle around the normal. u = (1 + z) / 2.
vec3 beckmannNormal(float alpha, vec3 normal, vec2 numbers) {
  const vec3 d = sphereDirection(numbers);
  const float z = dotProduct(normal, d);
  const vec3 across = d - normal * z;
  const float sine2 = dotProduct(across, across);
  // Of small u the sum 1 + z has lost the digits; 1 - z^2 = 4 u (1 - u).
  const float u = z < 0.0 ? 0.5 * sine2 / (1.0 - z) : 0.5 + 0.5 * z;
  const float tangent = alpha * sqrt(greater(-logOf(greater(u, 1e-30)), 0.0));
  return unitOr(normal + across * (sine2 > 1e-14 ? tangent * inversesqrt(sine2) : 0.5 * alpha), normal);
}

// The share of facets with the normal h that v sees: Smith's term to Walter's rational approximation.
float beckmannShadowing(float alpha, vec3 normal, vec3 v, vec3 h) {
  const float cosine = dotProduct(normal, v);
  if (!(dotProduct(h, v) * cosine > 0.0)) return 0.0;
  const float slope = alpha * sqrt(squaredSine(normal, v, cosine)) / abs(cosine);
  if (slope <= 0.625) return 1.0;
  const float b = 1.0 / slope;
  return (3.535 * b + 2.181 * b * b) / (1.0 + 2.276 * b + 2.577 * b * b);
}

// Two directions on the upper side and what the facets between them do.
struct Facets {
  bool above;       // both directions are
  float ci, co;     // cosines to the normal
  float ch;         // of either to h
  float specular;   // D G / (4 ci co), without Fresnel's term
  float pdf;        // of wo, if h is drawn by beckmannNormal()
};

Facets facetsBetween(float alpha, vec3 normal, vec3 towardsI, vec3 towardsO) {
  const vec3 wi = unitOr(towardsI, normal), wo = unitOr(towardsO, normal);
  Facets f;
  f.ci = dotProduct(normal, wi);
  f.co = dotProduct(normal, wo);
  f.above = f.ci > 0.0 && f.co > 0.0;
  const vec3 h = unitOr(wi + wo, normal);
  f.ch = dotProduct(h, wo);
  const float density = beckmannDensity(alpha, normal, h);
  f.specular = density * beckmannShadowing(alpha, normal, wi, h) *
               beckmannShadowing(alpha, normal, wo, h) / (4.0 * f.ci * f.co);
  f.pdf = density * dotProduct(normal, h) / (4.0 * f.ch);
  return f;
}

vec3 mirroredAt(vec3 h, vec3 wi) { return h * (2.0 * dotProduct(h, wi)) - wi; }
