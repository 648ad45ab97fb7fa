// A perfect mirror on the upper side: a delta distribution.
vec3 mirrorEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) { return vec3(0.0); }

float mirrorPdf(Material m, vec3 normal, vec3 wi, vec3 wo) { return 0.0; }

vec3 mirrorSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  const float cosine = dotProduct(normal, wi);
  wo = normal * (2.0 * cosine) - wi;
  return cosine > 0.0 ? vec3(1.0) : vec3(0.0);
}
