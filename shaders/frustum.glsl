// The frustum of a packet's rays, and the groups of rays that may share one. A subgroup of 8 lanes
// holds 64 rays, R a lane.
#ifndef LAVER_FRUSTUM
#define LAVER_FRUSTUM
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "rays.glsl"
#include "shared/triangle.h"

// Rays walk together whose slopes differ from the leader's by no more than this: wide frusta meet
// too much of the tree.
const float WINDOW = 0.02;

uint lane() { return gl_SubgroupInvocationID; }

float minOfLanes(float x) {
  x = min(x, subgroupShuffleXor(x, 1u));
  x = min(x, subgroupShuffleXor(x, 2u));
  return min(x, subgroupShuffleXor(x, 4u));
}
float maxOfLanes(float x) { return -minOfLanes(-x); }
uint orOfLanes(uint x) {
  x |= subgroupShuffleXor(x, 1u);
  x |= subgroupShuffleXor(x, 2u);
  return x | subgroupShuffleXor(x, 4u);
}
// Bounds of pairs: lowest in xy, highest in zw.
vec4 hull(vec4 bounds, vec2 x) { return vec4(min(bounds.xy, x), max(bounds.zw, x)); }
vec4 hullOfLanes(vec4 bounds) {
  return vec4(minOfLanes(bounds.x), minOfLanes(bounds.y), maxOfLanes(bounds.z),
              maxOfLanes(bounds.w));
}
vec3 fromLane(vec3 v, uint from) {
  return vec3(subgroupShuffle(v.x, from), subgroupShuffle(v.y, from), subgroupShuffle(v.z, from));
}

// All rays of one walk, relative to `origin`: at depth z, 0 <= z, a ray stands between
// slopes.xy * z - slack.xy and slopes.zw * z + slack.zw, and its hits lie between two depths.
struct Frustum {
  vec3 origin;
  uint axis;
  float sign;
  vec4 slopes;  // lowest u and v, highest u and v
  vec4 slack;
  float first, last;
};

// Sideways padding of boxes and triangles, with e = 2^-24, A = max |origin| + 1: a triangle test
// made at the origin errs by less than 11 e A (lane.glsl), products of slope and depth by e A, box
// corners by e A: below 16 e A.
float padOf(vec3 origin) {
  return 9.5367432e-7 * (max(abs(origin.x), max(abs(origin.y), abs(origin.z))) + 1.0);
}

// May a box, permuted and relative to the origin, hold a hit?
bool meets(Frustum f, vec3 low, vec3 high) {
  const float near = max(low.z, f.first), far = min(high.z, f.last);
  const vec2 lowest = min(f.slopes.xy * near, f.slopes.xy * far) - f.slack.xy;
  const vec2 highest = max(f.slopes.zw * near, f.slopes.zw * far) + f.slack.zw;
  return near <= far && all(lessThanEqual(lowest, high.xy)) &&
         all(greaterThanEqual(highest, low.xy));
}

Shear axisOf(Frustum f) { return Shear(f.axis, f.sign, 0.0, 0.0); }

// The lowest lane, and in it the lowest ray, that still waits. Returns false if none does.
bool leaderOf(uint waiting, out uint leadLane, out uint leadRay) {
  const uint lanes = orOfLanes(waiting != 0u ? 1u << lane() : 0u);
  leadLane = uint(findLSB(lanes));
  leadRay = subgroupShuffle(uint(findLSB(waiting)), leadLane & 7u);
  return lanes != 0u;
}

// Takes the rays that may walk with the leader out of `waiting` and bounds their slopes.
uint gatherGroup(Shear shears[R], inout uint waiting, uint leadLane, uint leadRay, inout Frustum f) {
  Shear lead = shears[0];
  [[unroll]] for (uint r = 1u; r < R; ++r) {
    if (r == leadRay) lead = shears[r];
  }
  f.axis = subgroupShuffle(lead.axis, leadLane);
  f.sign = subgroupShuffle(lead.sign, leadLane);
  const float u = subgroupShuffle(lead.u, leadLane), v = subgroupShuffle(lead.v, leadLane);
  uint group = 0u;
  f.slopes = vec4(2.0, 2.0, -2.0, -2.0);
  [[unroll]] for (uint r = 0u; r < R; ++r) {
    const Shear s = shears[r];
    const bool leads = lane() == leadLane && r == leadRay;
    const bool joins = leads || ((waiting >> r & 1u) != 0u && s.axis == f.axis &&
                                 s.sign == f.sign && max(abs(s.u - u), abs(s.v - v)) <= WINDOW);
    group |= joins ? 1u << r : 0u;
    f.slopes = joins ? hull(f.slopes, vec2(s.u, s.v)) : f.slopes;
  }
  f.slopes = hullOfLanes(f.slopes);
  waiting &= ~group;
  return group;
}

#endif
