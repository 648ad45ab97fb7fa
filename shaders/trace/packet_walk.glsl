// A packet's steps between nodes, with one child per lane, and its stack. The code is branchless: a lavapipe
// `if` executes both sides.
#include "trace/frustum.glsl"
#include "resources.glsl"

// One stack for the subgroup: entry i is in lane i % 8, row i / 8. The host makes it large enough for any
// walk.
const uint STACK_ROWS = (STACK + 7u) / 8u;
uint stackRows[STACK_ROWS];
int stackSize;

// Reads an entry; REF_NONE for negative numbers.
uint entry(int number) {
  const uint i = uint(max(number, 0));
  uint row = stackRows[0];
  [[unroll]] for (uint b = 1u; b < STACK_ROWS; ++b) row = i >= 8u * b ? stackRows[b] : row;
  const uint ref = subgroupShuffle(row, i & 7u);
  return number < 0 ? REF_NONE : ref;
}

// Pops the top entry.
uint pop() { return entry(--stackSize); }

// One step of a bitonic sort across lanes, ascending if `up`.
uint exchange(uint key, uint distance, bool up) {
  const uint other = subgroupShuffleXor(key, distance);
  const bool lower = (lane() & distance) == 0u;
  return lower == up ? min(key, other) : max(key, other);
}

// Pushes the children of a node that the frustum intersects and returns the nearest one, or pops the stack if
// there is none.
uint enterNode(Frustum f, uint node) {
  const int texel = int((node * NODE_WIDTH + lane()) * 2u);
  const uvec4 low = texelFetch(nodeTexels, texel);
  const uvec4 high = texelFetch(nodeTexels, texel + 1);
  const vec3 a = permute(f.axis, texelVec3(low));
  const vec3 b = permute(f.axis, texelVec3(high));
  // If the sign is negative, the high corner is nearer.
  const vec3 near = vec3(a.xy, lesser(a.z, b.z)), far = vec3(b.xy, greater(a.z, b.z));
  const bool hit = low.w != REF_NONE && intersects(f, near, far);

  // Depths are not negative, so their bits sort like them; the last three bits name the lane.
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
  const uint top = pop(), nearest = subgroupShuffle(ref, 0u);
  return count > 0 ? nearest : top;
}
