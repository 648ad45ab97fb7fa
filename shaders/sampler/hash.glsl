// Hashes of pixels and samples; of the bindings they read only `params`.
#include "resources.glsl"

// Jarzynski and Olano's pcg3d ("Hash Functions for GPU Rendering", JCGT 9(3), 2020). Its low bits, on which
// scramble() bases the leading digits, are correlated between neighbouring pixels; the last step mixes the
// high bits into them.
uvec3 hashOf(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v ^ v >> 16u;
}

// Pairs that are independent between pixels, samples and dimensions.
uvec2 hashedPair(uvec2 pixel, uint number, uint dimension) {
  const uvec3 hash = hashOf(uvec3(pixel, params.seedHash ^ dimension * 0x9e3779b9u));
  return hashOf(uvec3(hash.xy, number)).xy;
}

// Rounds a fraction to the middle of its cell of a grid, coarse enough that pixel + jitter is exact in float.
// No sample leaves its pixel or stratum by rounding, and none lies on a border, where two pixels' filters
// would count it.
uvec2 cellMiddle(uvec2 fraction) {
  const uint middle = params.halfStep;
  return fraction & -(middle << 1) | middle;
}
