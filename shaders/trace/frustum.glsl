// The frustum of a packet's rays, and the selection of rays that can share one. A subgroup of 8 lanes holds 8
// R rays, R per lane.
#include "trace/rays.glsl"
#include "shared/box.h"

uint lane() { return gl_SubgroupInvocationID; }

float minOfLanes(float x) {
  x = lesser(x, subgroupShuffleXor(x, 1u));
  x = lesser(x, subgroupShuffleXor(x, 2u));
  return lesser(x, subgroupShuffleXor(x, 4u));
}
float maxOfLanes(float x) { return -minOfLanes(-x); }
uint orOfLanes(uint x) {
  x |= subgroupShuffleXor(x, 1u);
  x |= subgroupShuffleXor(x, 2u);
  return x | subgroupShuffleXor(x, 4u);
}
// Bounds of pairs: minima in xy, maxima in zw.
vec4 hull(vec4 bounds, vec2 x) {
  return vec4(lesser(x.x, bounds.x), lesser(x.y, bounds.y), greater(x.x, bounds.z),
              greater(x.y, bounds.w));
}
vec4 hullOfLanes(vec4 bounds) {
  return vec4(minOfLanes(bounds.x), minOfLanes(bounds.y), maxOfLanes(bounds.z),
              maxOfLanes(bounds.w));
}
vec3 fromLane(vec3 v, uint from) {
  return vec3(subgroupShuffle(v.x, from), subgroupShuffle(v.y, from), subgroupShuffle(v.z, from));
}

// Only the slopes of a shear.
Shear fromLane(Shear s, uint from) {
  return Shear(0u, 0.0, subgroupShuffle(s.u, from), subgroupShuffle(s.v, from));
}

// The rays of one walk in permuted space (u, v, depth). At a depth of z >= 0 beyond `depth`, a ray is between
// window.xy + slopes.xy * z and window.zw + slopes.zw * z; hits lie from `first` to `last`.
struct Frustum {
  Shear axis;  // slopes 0
  vec4 slopes;
  vec4 window;  // where rays cross `depth`, grown by the pad
  float depth;
  float first, last;
};

// What the size of triangles adds to a frustum's pad: their corners lie in [-1, 1]^3, or else their
// boxes are grown (packet_leaf.glsl).
const float TRIANGLE_PAD = HAS_FAR_PARTS ? 0.0 : 9.5367432e-7;

// Whether the frustum intersects the box between two permuted corners.
bool intersects(Frustum f, vec3 low, vec3 high) {
  precise float near = greater(low.z - f.depth, f.first), far = lesser(high.z - f.depth, f.last);
  precise vec4 atNear = f.slopes * near, atFar = f.slopes * far;
  precise vec2 above = high.xy - f.window.xy, below = low.xy - f.window.zw;
  return near <= far && lesser(atNear.x, atFar.x) <= above.x &&
         lesser(atNear.y, atFar.y) <= above.y && greater(atNear.z, atFar.z) >= below.x &&
         greater(atNear.w, atFar.w) >= below.y;
}

// Forms a group: removes from `waiting` the rays that can walk with the first waiting ray because their
// slopes differ from its slopes by at most packetWindow. Sets the slopes of the whole group in `f`, and of
// this lane's rays in `own`.
uint formGroup(Shear shears[R], inout uint waiting, inout Frustum f, inout Frustum own) {
  const uint leadLane = uint(findLSB(orOfLanes(waiting != 0u ? 1u << lane() : 0u))) & 7u;
  const uint leadRay = subgroupShuffle(uint(findLSB(waiting)), leadLane);
  Shear lead = shears[0];
  FOR_RAYS (uint r = 1u; r < R; ++r) {
    if (r == leadRay) lead = shears[r];
  }
  f.axis = Shear(subgroupShuffle(lead.axis, leadLane), subgroupShuffle(lead.sign, leadLane), 0.0,
                 0.0);
  const float u = subgroupShuffle(lead.u, leadLane), v = subgroupShuffle(lead.v, leadLane);
  uint group = 0u;
  f.slopes = vec4(2.0, 2.0, -2.0, -2.0);
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const Shear s = shears[r];
    const bool leads = lane() == leadLane && r == leadRay;
    const bool joins = leads || ((waiting >> r & 1u) != 0u && s.axis == f.axis.axis &&
                                 s.sign == f.axis.sign &&
                                 greater(abs(s.u - u), abs(s.v - v)) <= params.packetWindow);
    group |= joins ? 1u << r : 0u;
    const vec4 wider = hull(f.slopes, vec2(s.u, s.v));
    f.slopes = joins ? wider : f.slopes;
  }
  own = f;
  f.slopes = hullOfLanes(f.slopes);
  waiting &= ~group;
  return group;
}
