#version 460
#extension GL_GOOGLE_include_directive : require
#include "integrator.glsl"
#include "shared/direction.h"

// Farther than any two points of the scene, which lies in [-1, 1]^3, are apart.
const float SCENE_REACH = 4.0;

// Ambient occlusion: 1 if a cosine-distributed direction around the shading normal leaves the scene,
// else 0; 0 for a miss.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  vec3 points[R], ways[R];
  bool live[R], clear[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    live[r] = hits.slot[r] != NO_HIT;
    const Surface s = surfaceAt(rays.origin, rays.direction[r], live[r] ? hits.slot[r] : 0u);
    ways[r] = cosineDirection(s.normal, moreNumbers(r)) * SCENE_REACH;
    points[r] = beside(s, ways[r]);
  }
  unoccluded(points, ways, live, clear);
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (clear[r]) radiance[r] = vec3(1.0);
  }
}
