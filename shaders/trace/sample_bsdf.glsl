// Directions that a BSDF draws, and its values; of no render. Input: wi and the first number; the second
// number, texture coordinates, and z of a given wo, whose x and y stand for the numbers. Output: the drawn wo and its pdf; its weight; eval of wo
// for light of 1.
layout(local_size_x = 64) in;
layout(binding = BINDINGS) uniform textureBuffer inputTexels;
layout(binding = BINDINGS + 1) writeonly buffer OutputBlock { vec4 outputOf[]; };
// Here Pass holds: region.x the count, region.y the material, region.z whether wo is given.

void main() {
  const uint n = gl_GlobalInvocationID.x;
  if (n >= pass.region.x) return;
  const vec4 first = texelFetch(inputTexels, int(n) * 2);
  const vec4 second = texelFetch(inputTexels, int(n) * 2 + 1);
  Surface s;
  s.position = vec3(0.0);
  s.geometric = s.normal = vec3(0.0, 0.0, 1.0);
  s.t = s.offset = 0.0;
  s.material = pass.region.y;
  s.weights = vec3(1.0 - second.y - second.z, second.yz);
  s.id = pass.region.y;  // a triangle per material
  const Material m = materialOf(s);
  vec3 wo;
  vec3 weight = sampleBsdf(m, s.normal, first.xyz, vec2(first.w, second.x), wo);
  if (pass.region.z != 0u) {
    wo = vec3(first.w, second.x, second.w);
    weight = vec3(0.0);
  }
  outputOf[n * 3u] = vec4(wo, pdfBsdf(m, s.normal, first.xyz, wo));
  outputOf[n * 3u + 1u] = vec4(weight, 0.0);
  outputOf[n * 3u + 2u] = vec4(evalBsdf(m, s.normal, first.xyz, wo, vec3(1.0)), 0.0);
}
