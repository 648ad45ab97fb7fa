#version 460
#extension GL_GOOGLE_include_directive : require
#include "integrator.glsl"

// The surface's albedo; 0 where nothing is hit.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (hits.slot[r] == NO_HIT) continue;
    radiance[r] = albedoOf(surfaceAt(rays.origin, rays.direction[r], hits.slot[r]));
  }
}
