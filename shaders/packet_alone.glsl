// Rays that share nothing, such as those of a hemisphere: each walks by itself, a node's children
// and a leaf's triangles in the lanes.
#ifndef LAVER_PACKET_ALONE
#define LAVER_PACKET_ALONE
#include "packet_walk.glsl"

// What enterNode() takes, of one ray from `point`.
Frustum frustumOf(Shear shear, vec3 point, float last) {
  const vec3 from = permute(shear, point);
  const float pad = padOf(point);
  return Frustum(Shear(shear.axis, shear.sign, 0.0, 0.0), vec4(shear.u, shear.v, shear.u, shear.v),
                 vec4(from.xy - pad, from.xy + pad), from.z, 0.0, last);
}

// Whether anything lies between a point and point + way. All lanes ask the same.
bool occludedAlone(vec3 point, vec3 way) {
  const Shear shear = shearOf(way);
  const float last = alongAxis(abs(way), shear.axis) * DEPTH_SLACK;
  const Frustum f = frustumOf(shear, point, last);
  const vec3 from = permute(shear, point);
  const vec3 wayThere = permute(shear, way);
  bool blocked = false;
  stackSize = 0;
  uint ref = params.film.w;
  do {
    do ref = enterNode(f, ref); while (ref < REF_LEAF);
    do {
      const bool none = ref == REF_NONE;
      const uint slot = none ? 0u : ref & REF_INDEX_MASK;
      // Lanes beyond the leaf's end read what follows; the host pads the buffer.
      const int texel = int((slot + lane()) * 3u);
      const uvec4 first = texelFetch(triangleTexels, texel);
      const uvec4 second = texelFetch(triangleTexels, texel + 1);
      const vec3 a = permute(shear, texelVec3(first));
      const vec3 b = permute(shear, texelVec3(second));
      const vec3 c = permute(shear, texelVec3(texelFetch(triangleTexels, texel + 2)));
      bool meets = lane() <= subgroupShuffle(second.w, 0u) &&
                   blocksWay(shear, last, wayThere, crossProduct(b - a, c - a), a - from, b - from,
                             c - from);
#ifdef LAVER_SPHERES
      const float radius = uintBitsToFloat(second.x);
      const bool byBall = ballBlocks(shear, last, a - from, wayThere - (a - from),
                                     endsOf(a.z, radius, from.z), radius);
      const bool held = lane() <= subgroupShuffle(second.w, 0u);
      const bool ball = texelFetch(triangleTexels, texel + 2).w == IS_SPHERE;
      meets = ball ? held && byBall : meets;
#endif
      blocked = orOfLanes(!none && meets ? 1u : 0u) != 0u;
      const uint next = pop();
      ref = blocked ? REF_NONE : next;
    } while (ref >= REF_LEAF && ref != REF_NONE);
  } while (ref != REF_NONE);
  return blocked;
}

void unoccluded(vec3 points[R], vec3 ways[R], bool live[R], out bool clear[R]) {
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) waiting |= live[r] ? 1u << r : 0u;
  uint open = waiting;
  while (orOfLanes(waiting) != 0u) {
    const uint lender = uint(findLSB(orOfLanes(waiting != 0u ? 1u << lane() : 0u))) & 7u;
    const uint turn = subgroupShuffle(uint(findLSB(waiting)), lender);
    vec3 point = points[0], way = ways[0];
    FOR_RAYS (uint r = 1u; r < R; ++r) {
      point = r == turn ? points[r] : point;
      way = r == turn ? ways[r] : way;
    }
    const bool blocked = occludedAlone(fromLane(point, lender), fromLane(way, lender));
    const uint done = lane() == lender ? 1u << turn : 0u;
    waiting &= ~done;
    open &= blocked ? ~done : ~0u;
  }
  FOR_RAYS (uint r = 0u; r < R; ++r) clear[r] = (open >> r & 1u) != 0u;
}

#endif
