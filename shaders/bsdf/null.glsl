// No surface: light goes straight on. A delta distribution.
vec3 nullEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) { return vec3(0.0); }

float nullPdf(Material m, vec3 normal, vec3 wi, vec3 wo) { return 0.0; }

vec3 nullSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  wo = -wi;
  return vec3(1.0);
}
