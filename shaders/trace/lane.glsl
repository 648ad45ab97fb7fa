// The `lane` traversal: one ray per invocation.
#include "trace/lane_walk.glsl"

Hits closest(Rays rays) {
  Hits hits;
  for (uint r = 0u; r < R; ++r)
    hits.slot[r] =
        closestLane(rays.origin[r], rays.direction[r], rays.tmin[r], rays.tmax[r], rays.isActive[r],
                    NO_HIT);
  return hits;
}

Hits closestFromOne(Rays rays) { return closest(rays); }

void unoccluded(Segments s, out bool clear[R]) {
  for (uint r = 0u; r < R; ++r)
    clear[r] = unoccludedLane(s.from[r], s.direction[r], false, vec3(0.0), s.isActive[r]);
}

void unoccludedToOne(vec3 light, vec3 points[R], bool isActive[R], out bool clear[R]) {
  for (uint r = 0u; r < R; ++r)
    clear[r] = unoccludedLane(points[r], light - points[r], true, light, isActive[r]);
}
