// The `lane` traversal: one ray an invocation.
#ifndef LAVER_LANE
#define LAVER_LANE
#include "lane_walk.glsl"

Hits closest(Rays rays) {
  Hits hits;
  for (uint r = 0u; r < R; ++r)
    hits.slot[r] =
        closestLane(rays.origin, rays.direction[r], rays.tmin[r], rays.tmax[r], rays.live[r]);
  return hits;
}

void visible(vec3 light, vec3 points[R], bool live[R], out bool seen[R]) {
  for (uint r = 0u; r < R; ++r)
    seen[r] = visibleLane(points[r], light - points[r], true, light, live[r]);
}

void unoccluded(vec3 points[R], vec3 ways[R], bool live[R], out bool clear[R]) {
  for (uint r = 0u; r < R; ++r)
    clear[r] = visibleLane(points[r], ways[r], false, vec3(0.0), live[r]);
}

#endif
