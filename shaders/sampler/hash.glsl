// Hashes of pixels and samples; they read parameters only.
#include "resources.glsl"

// Jarzynski and Olano's pcg3d ("Hash Functions for GPU Rendering", JCGT 9(3), 2020). Its low bits,
// which scramble() hands to the first digits, show the neighbours of a pixel; the last step hides
// them behind the high ones.
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

// Independent pairs, other ones in each dimension.
uvec2 hashedPair(uvec2 pixel, uint number, uint dimension) {
  const uvec3 hash = hashOf(uvec3(pixel, params.seedHash ^ dimension * 0x9e3779b9u));
  return hashOf(uvec3(hash.xy, number)).xy;
}

// The middle of the cell that holds a fraction, of a grid so fine that pixel + jitter is exact: no
// sample is moved out of its pixel or stratum, and no two pixels' filters count one on their border.
uvec2 cellMiddle(uvec2 fraction) {
  const uint middle = params.halfStep;
  return fraction & -(middle << 1) | middle;
}
