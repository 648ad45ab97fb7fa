#version 460
#extension GL_GOOGLE_include_directive : require
#include "integrator.glsl"

// Component-wise absolute value of the shading normal; black where nothing is hit.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (hits.slot[r] == NO_HIT) continue;
    radiance[r] = abs(surfaceAt(rays.origin, rays.direction[r], hits.slot[r]).normal);
  }
}
