// Ambient occlusion: 1 if no surface lies within `length` along a cosine-distributed direction around the
// shading normal, else 0; 0 for a miss.
#include "shared/direction.h"

void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  Segments segments;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const bool hit = hits.slot[r] != NO_HIT;
    const Surface s = surfaceAt(rays.origin[r], rays.direction[r], hit ? hits.slot[r] : 0u);
    segments.direction[r] = cosineDirection(s.normal, randomPair(r, HAS_LENS ? 2u : 1u)) * xml_length;
    segments.from[r] = offsetOrigin(s, segments.direction[r]);
    segments.isActive[r] = hit;
  }
  bool clear[R];
  unoccluded(segments, clear);
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (clear[r]) radiance[r] = vec3(1.0);
  }
}
