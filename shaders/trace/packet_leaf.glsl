// A leaf's triangles, one per lane, and which of them the rays of each lane may hit. Packets of 32 rays
// (SHARES_TESTS) are used for fine meshes, where a leaf has few triangles for each lane's rays. They take two
// leaves at once if these fit into the lanes, and distribute the tests among the lanes
// (trace/packet_pairs.glsl).
#include "trace/packet_walk.glsl"
#include "trace/far_points.glsl"
#include "trace/plane.glsl"
#include "shared/sphere.h"

// The triangle that this lane holds, permuted.
struct LeafTriangle {
  vec3 a, b, c;
  uint id, slot;
  float radius;  // of a sphere, whose centre is a; else 0
};

// Number of triangles of a leaf; 0 for REF_NONE.
uint trianglesOf(uint ref) {
  return ref == REF_NONE ? 0u : (ref >> REF_COUNT_SHIFT & 7u) + 1u;
}

// Sets `slot` to this lane's triangle. Lanes beyond the end read what follows; the host pads the buffer.
// Packets of 32 also pop the next leaf if 8 lanes can hold both. Returns the number of triangles, 0 for
// REF_NONE.
uint takeLeaf(uint ref, out uint slot) {
  const uint count = trianglesOf(ref);
  slot = (count == 0u ? 0u : ref & REF_INDEX_MASK) + lane();
  if (!SHARES_TESTS) return count;
  const uint next = entry(stackSize - 1);
  const uint more = next >= REF_LEAF ? trianglesOf(next) : 0u;
  const bool fits = more > 0u && count + more <= MAX_LEAF;
  if (fits && lane() >= count) slot = (next & REF_INDEX_MASK) + lane() - count;
  stackSize -= fits ? 1 : 0;
  return count + (fits ? more : 0u);
}

// Loads the triangles. `mine` has the bits of those that this lane's rays, bounded by `own`, may hit.
LeafTriangle loadLeaf(Frustum f, Frustum own, uint ref, out uint mine) {
  LeafTriangle t;
  const uint count = takeLeaf(ref, t.slot);
  const int texel = int(t.slot * 3u);
  const uvec4 a = texelFetch(triangleTexels, texel);
  const uvec4 b = texelFetch(triangleTexels, texel + 1);
  const uvec4 c = texelFetch(triangleTexels, texel + 2);
  t.a = permute(f.axis, texelVec3(a));
  t.b = permute(f.axis, texelVec3(b));
  t.c = permute(f.axis, texelVec3(c));
  t.id = a.w;
  vec3 low = vec3(lesser(t.a.x, lesser(t.b.x, t.c.x)), lesser(t.a.y, lesser(t.b.y, t.c.y)),
                  lesser(t.a.z, lesser(t.b.z, t.c.z)));
  vec3 high = vec3(greater(t.a.x, greater(t.b.x, t.c.x)), greater(t.a.y, greater(t.b.y, t.c.y)),
                   greater(t.a.z, greater(t.b.z, t.c.z)));
  t.radius = HAS_SPHERES && c.w == IS_SPHERE ? uintBitsToFloat(b.x) : 0.0;
  if (HAS_SPHERES && t.radius > 0.0) {
    low = t.a - t.radius * SPHERE_GROWTH;
    high = t.a + t.radius * SPHERE_GROWTH;
  }
  if (HAS_FAR_PARTS) {
    const vec3 size = vec3(greater(abs(low.x), abs(high.x)), greater(abs(low.y), abs(high.y)),
                           greater(abs(low.z), abs(high.z)));
    const float growth = BOX_GROWTH * largestAxis(size);
    low -= growth;
    high += growth;
  }
  mine = 0u;
  if (SHARES_TESTS) {
    // Most lanes hold a triangle, so a loop over only those that any ray may hit would take longer.
    [[unroll]] for (uint i = 0u; i < MAX_LEAF; ++i)
      mine |= intersects(own, fromLane(low, i), fromLane(high, i)) ? 1u << i : 0u;
    mine &= (1u << count) - 1u;
  } else {
    uint hitting = orOfLanes(lane() < count && intersects(f, low, high) ? 1u << lane() : 0u);
    while (hitting != 0u) {
      const uint from = uint(findLSB(hitting));
      hitting &= hitting - 1u;
      mine |= intersects(own, fromLane(low, from), fromLane(high, from)) ? 1u << from : 0u;
    }
  }
  return t;
}

// The next of this lane's triangles. A lane with no triangle left repeats one; testing a triangle twice does
// not change the result.
uint nextOf(inout uint mine) {
  const uint from = uint(findLSB(mine)) & 7u;
  mine &= mine - 1u;
  return from;
}
