// The material of a hit. A BSDF NAME, in bsdf/NAME.glsl, is three functions of unit vectors, except that wi
// and wo of NAMEEval may have any length. wi points to where the light goes, wo to where it comes from, both
// away from the surface:
//   vec3 NAMEEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light)
//     `light`, the irradiance from wo (cosine included), times the BSDF: the radiance towards wi.
//   float NAMEPdf(Material m, vec3 normal, vec3 wi, vec3 wo)
//     density of NAMESample's directions per solid angle; 0 for a delta distribution.
//   vec3 NAMESample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo)
//     samples wo; returns BSDF * cosine / density.
// evalBsdf(), pdfBsdf() and sampleBsdf(), composed from the kernel's key, call the right one.
#include "shared/direction.h"
#include "trace/surface.glsl"

Material materialOf(Surface s) {
  Material m;
  m.albedo = colourOf(s);
  m.bsdf = 0u;
  m.numbers = vec4(0.0);
  if (HAS_BSDF_RECORDS) {
    const int texel = int(s.material) * 2;
    m.bsdf = texelFetch(materialTexels, texel).w;
    m.numbers = uintBitsToFloat(texelFetch(materialTexels, texel + 1));
  }
  return m;
}
