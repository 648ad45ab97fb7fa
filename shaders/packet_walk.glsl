// One step of a packet's walk: a node's children, or a leaf's triangles, in the lanes. Nothing
// branches: a lavapipe `if` runs both sides.
#ifndef LAVER_PACKET_WALK
#define LAVER_PACKET_WALK
#include "frustum.glsl"
#include "resources.glsl"
#ifdef LAVER_SPHERES
#include "shared/sphere.h"
#endif

// One stack for the subgroup: entry i lies in lane i % 8, row i / 8. The host makes it large enough
// for any walk.
const uint STACK_ROWS = (STACK + 7u) / 8u;
uint stackRows[STACK_ROWS];
int stackSize;

// Takes the top off; REF_NONE off an empty stack.
uint pop() {
  stackSize--;
  const uint top = uint(max(stackSize, 0));
  uint row = stackRows[0];
  [[unroll]] for (uint b = 1u; b < STACK_ROWS; ++b) row = top >= 8u * b ? stackRows[b] : row;
  const uint ref = subgroupShuffle(row, top & 7u);
  return stackSize < 0 ? REF_NONE : ref;
}

// One step of a bitonic sort across lanes, ascending where `up`.
uint exchange(uint key, uint distance, bool up) {
  const uint other = subgroupShuffleXor(key, distance);
  const bool lower = (lane() & distance) == 0u;
  return lower == up ? min(key, other) : max(key, other);
}

// Pushes the children of a node that the frustum meets and returns the nearest, or else what lies
// on the stack.
uint enterNode(Frustum f, uint node) {
  const int texel = int((node * NODE_WIDTH + lane()) * 2u);
  const uvec4 low = texelFetch(nodeTexels, texel);
  const uvec4 high = texelFetch(nodeTexels, texel + 1);
  const vec3 a = permute(f.axis, texelVec3(low));
  const vec3 b = permute(f.axis, texelVec3(high));
  // Where the sign is negative the high corner is nearer.
  const vec3 near = vec3(a.xy, lesser(a.z, b.z)), far = vec3(b.xy, greater(a.z, b.z));
  const bool hit = low.w != REF_NONE && meets(f, near, far);

  // Depths are not negative, so their bits sort like them; the last three name the lane.
  uint key = hit ? (floatBitsToUint(greater(near.z - f.depth, 0.0)) & ~7u) | lane() : REF_NONE;
  const bool second = (lane() & 2u) == 0u, third = (lane() & 4u) == 0u;
  key = exchange(key, 1u, second);
  key = exchange(key, 2u, third);
  key = exchange(key, 1u, third);
  key = exchange(key, 4u, true);
  key = exchange(key, 2u, true);
  key = exchange(key, 1u, true);

  const uint ref = subgroupShuffle(low.w, key & 7u);
  int count = hit ? 1 : 0;
  count += subgroupShuffleXor(count, 1u);
  count += subgroupShuffleXor(count, 2u);
  count += subgroupShuffleXor(count, 4u);
  const int end = stackSize + count - 1;
  const uint pushed = subgroupShuffle(ref, uint(end - int(lane())) & 7u);
  [[unroll]] for (uint b = 0u; b < STACK_ROWS; ++b) {
    const int entry = int(lane() + 8u * b);
    stackRows[b] = entry >= stackSize && entry < end ? pushed : stackRows[b];
  }
  stackSize = count > 0 ? end + 1 : stackSize;
  const uint top = pop();
  return count > 0 ? subgroupShuffle(ref, 0u) : top;
}

// The triangle that this lane holds of a leaf, permuted, and its bounds.
struct LeafTriangle {
  vec3 a, b, c;
  vec3 low, high;
  uint id;
#ifdef LAVER_SPHERES
  float radius;  // of a sphere, whose centre is a; else 0
#endif
};

// `mine`: which triangles of a leaf the rays of this lane, `own`, may meet; none for REF_NONE.
LeafTriangle loadLeaf(Frustum f, Frustum own, uint ref, out uint slot, out uint mine) {
  const bool none = ref == REF_NONE;
  slot = none ? 0u : ref & REF_INDEX_MASK;
  // Lanes beyond the leaf's end read what follows; the host pads the buffer.
  const int texel = int((slot + lane()) * 3u);
  const uvec4 a = texelFetch(triangleTexels, texel);
  const uvec4 b = texelFetch(triangleTexels, texel + 1);
  const uvec4 c = texelFetch(triangleTexels, texel + 2);
  LeafTriangle t;
  t.a = permute(f.axis, texelVec3(a));
  t.b = permute(f.axis, texelVec3(b));
  t.c = permute(f.axis, texelVec3(c));
  t.id = a.w;
  t.low = vec3(lesser(t.a.x, lesser(t.b.x, t.c.x)), lesser(t.a.y, lesser(t.b.y, t.c.y)),
               lesser(t.a.z, lesser(t.b.z, t.c.z)));
  t.high = vec3(greater(t.a.x, greater(t.b.x, t.c.x)), greater(t.a.y, greater(t.b.y, t.c.y)),
                greater(t.a.z, greater(t.b.z, t.c.z)));
#ifdef LAVER_SPHERES
  t.radius = c.w == IS_SPHERE ? uintBitsToFloat(b.x) : 0.0;
  if (t.radius > 0.0) {
    t.low = t.a - t.radius * BALL_GROWTH;
    t.high = t.a + t.radius * BALL_GROWTH;
  }
#endif
  const bool hit = !none && lane() <= subgroupShuffle(b.w, 0u) && meets(f, t.low, t.high);
  uint meeting = orOfLanes(hit ? 1u << lane() : 0u);
  mine = 0u;
  while (meeting != 0u) {
    const uint from = uint(findLSB(meeting));
    meeting &= meeting - 1u;
    mine |= meets(own, fromLane(t.low, from), fromLane(t.high, from)) ? 1u << from : 0u;
  }
  return t;
}

// The next of this lane's triangles. A lane that has none left takes the last, of this leaf or of what
// follows: a triangle that is met twice, or with no need, changes nothing.
uint nextOf(inout uint mine) {
  const uint from = uint(findLSB(mine)) & 7u;
  mine &= mine - 1u;
  return from;
}

#endif
