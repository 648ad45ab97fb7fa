// Incoherent rays, which share neither origin nor direction: each lane of a packet walks with its own rays
// one after the other, as in `lane`.
#include "trace/lane_walk.glsl"

Hits closest(Rays rays) {
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) waiting |= rays.isActive[r] ? 1u << r : 0u;
  Hits hits;
  FOR_RAYS (uint r = 0u; r < R; ++r) hits.slot[r] = NO_HIT;
  do {
    const uint bit = waiting & -waiting;
    vec3 origin = rays.origin[0], direction = rays.direction[0];
    float tmin = rays.tmin[0], tmax = rays.tmax[0];
    FOR_RAYS (uint r = 1u; r < R; ++r) {
      const bool next = bit == 1u << r;
      origin = next ? rays.origin[r] : origin;
      direction = next ? rays.direction[r] : direction;
      tmin = next ? rays.tmin[r] : tmin;
      tmax = next ? rays.tmax[r] : tmax;
    }
    const uint slot = closestLane(origin, direction, tmin, tmax, bit != 0u, NO_HIT);
    FOR_RAYS (uint r = 0u; r < R; ++r) hits.slot[r] = bit == 1u << r ? slot : hits.slot[r];
    waiting ^= bit;
  } while (waiting != 0u);
  return hits;
}

void unoccluded(Segments s, out bool clear[R]) {
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) waiting |= s.isActive[r] ? 1u << r : 0u;
  uint open = 0u;
  do {
    const uint bit = waiting & -waiting;
    vec3 from = s.from[0], direction = s.direction[0];
    FOR_RAYS (uint r = 1u; r < R; ++r) {
      from = bit == 1u << r ? s.from[r] : from;
      direction = bit == 1u << r ? s.direction[r] : direction;
    }
    open |= unoccludedLane(from, direction, false, vec3(0.0), bit != 0u) ? bit : 0u;
    waiting ^= bit;
  } while (waiting != 0u);
  FOR_RAYS (uint r = 0u; r < R; ++r) clear[r] = (open & 1u << r) != 0u;
}
