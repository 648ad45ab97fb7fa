// Rays that share nothing, such as those of a hemisphere: each lane of a packet walks with one of its
// own after the other, as in `lane`.
#ifndef LAVER_PACKET_ALONE
#define LAVER_PACKET_ALONE
#include "lane_walk.glsl"

void unoccluded(vec3 points[R], vec3 ways[R], bool live[R], out bool clear[R]) {
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) waiting |= live[r] ? 1u << r : 0u;
  uint open = 0u;
  do {
    const uint bit = waiting & -waiting;
    vec3 point = points[0], way = ways[0];
    FOR_RAYS (uint r = 1u; r < R; ++r) {
      point = bit == 1u << r ? points[r] : point;
      way = bit == 1u << r ? ways[r] : way;
    }
    open |= visibleLane(point, way, false, vec3(0.0), bit != 0u) ? bit : 0u;
    waiting ^= bit;
  } while (waiting != 0u);
  FOR_RAYS (uint r = 0u; r < R; ++r) clear[r] = (open & 1u << r) != 0u;
}

#endif
