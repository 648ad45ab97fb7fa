// Directions that a BSDF samples. The preceding text includes the BSDF and defines SAMPLE and PDF as the
// names of its functions. Input: wi and the first number, the second number; output: wo and pdf, weight.
layout(local_size_x = 64) in;
layout(binding = BINDINGS) uniform textureBuffer inputTexels;
layout(binding = BINDINGS + 1) writeonly buffer OutputBlock { vec4 outputOf[]; };
// Pass is used as: region.x the count; core.xy the BSDF's numbers, as bits of floats.

void main() {
  const uint n = gl_GlobalInvocationID.x;
  if (n >= pass.region.x) return;
  const vec4 first = texelFetch(inputTexels, int(n) * 2);
  const vec3 normal = vec3(0.0, 0.0, 1.0);
  Material m;
  m.albedo = vec3(0.25, 0.5, 0.75);
  m.bsdf = 0u;
  m.numbers = vec4(uintBitsToFloat(pass.core.xy), 0.0, 0.0);
  vec3 wo;
  const vec2 numbers = vec2(first.w, texelFetch(inputTexels, int(n) * 2 + 1).x);
  const vec3 weight = SAMPLE(m, normal, first.xyz, numbers, wo);
  outputOf[n * 2u] = vec4(wo, PDF(m, normal, first.xyz, wo));
  outputOf[n * 2u + 1u] = vec4(weight, 0.0);
}
