#version 460
#extension GL_GOOGLE_include_directive : require
#include "integrator.glsl"
#include "shared/direction.h"

// Average visibility: 1 if nothing lies within a given length in a direction uniform on the
// hemisphere of the shading normal, else 0; 1 for a miss.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  vec3 points[R], ways[R];
  bool live[R], clear[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    live[r] = hits.slot[r] != NO_HIT;
    const Surface s = surfaceAt(rays.origin, rays.direction[r], live[r] ? hits.slot[r] : 0u);
    ways[r] = uniformDirection(s.normal, moreNumbers(r)) * params.clip.w;
    points[r] = beside(s, ways[r]);
  }
  unoccluded(points, ways, live, clear);
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (!live[r] || clear[r]) radiance[r] = vec3(1.0);
  }
}
