// Lambertian reflection: albedo / pi on the upper side.
vec3 diffuseEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {
  const bool above = dotProduct(normal, wi) > 0.0 && dotProduct(normal, wo) > 0.0;
  return above ? light * m.albedo * 0.31830989 : vec3(0.0);
}

float diffusePdf(Material m, vec3 normal, vec3 wi, vec3 wo) {
  const float cosine = dotProduct(normal, wo);
  return dotProduct(normal, wi) > 0.0 && cosine > 0.0 ? cosine * 0.31830989 : 0.0;
}

vec3 diffuseSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {
  wo = cosineDirection(normal, numbers);
  return dotProduct(normal, wi) > 0.0 ? m.albedo : vec3(0.0);
}
