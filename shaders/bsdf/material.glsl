// The material of a hit, Material, which materialOf(Surface) reads: m.albedo is its first colour, m.bsdf
// its BSDF. A BSDF NAME of bsdf/NAME.glsl is three functions of unit vectors, but for eval, whose wi and wo
// may be of any length; wi points to where the light is followed to, wo to where it comes from, both away
// from the surface:
//   vec3 NAMEEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light)
//     `light`, the irradiance from wo (cosine included), times the BSDF: the radiance towards wi.
//   float NAMEPdf(Material m, vec3 normal, vec3 wi, vec3 wo)
//     density of NAMESample's directions per solid angle; 0 for a delta distribution.
//   vec3 NAMESample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo)
//     draws wo; returns BSDF * cosine / density.
// In them the property `alpha` of the BSDF's row is xml_alpha: a vec3 or a float. The kernel holds those
// BSDFs that the scene has, and chooses among them in evalBsdf, pdfBsdf and sampleBsdf
// (host/kernels/compose_materials.cpp).
#include "shared/direction.h"
#include "trace/surface.glsl"

// ITU-R BT.709's, which a texture that stands for a number has in Nori.
float luminanceOf(vec3 color) { return dot(color, vec3(0.212671, 0.715160, 0.072169)); }
