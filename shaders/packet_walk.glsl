// One step of a packet's walk: a node's children, or a leaf's triangles, in the lanes.
#ifndef LAVER_PACKET_WALK
#define LAVER_PACKET_WALK
#include "frustum.glsl"
#include "resources.glsl"

// The stack is one for the subgroup, which is the workgroup.
shared uint stackRef[STACK];
uint stackSize;

uint pop() {
  if (stackSize == 0u) return endWalk();
  stackSize--;
  return stackRef[stackSize];
}

// One step of a bitonic sort across lanes, ascending where `up`.
uint exchange(uint key, uint distance, bool up) {
  const uint other = subgroupShuffleXor(key, distance);
  const bool lower = (lane() & distance) == 0u;
  return lower == up ? min(key, other) : max(key, other);
}

// Pushes the children of a node that the frustum meets and returns the nearest.
uint enterNode(Frustum f, uint node) {
  const int texel = int((node * NODE_WIDTH + lane()) * 2u);
  const uvec4 low = texelFetch(nodeTexels, texel);
  const uvec4 high = texelFetch(nodeTexels, texel + 1);
  const vec3 a = permute(axisOf(f), texelVec3(low) - f.origin);
  const vec3 b = permute(axisOf(f), texelVec3(high) - f.origin);
  // Where the sign is negative the high corner is nearer.
  const vec3 near = vec3(a.xy, min(a.z, b.z)), far = vec3(b.xy, max(a.z, b.z));
  const bool hit = low.w != REF_NONE && meets(f, near, far);

  // Depths are not negative, so their bits sort like them; the last three name the lane.
  uint key = hit ? (floatBitsToUint(max(near.z, 0.0)) & ~7u) | lane() : REF_NONE;
  const bool second = (lane() & 2u) == 0u, third = (lane() & 4u) == 0u;
  key = exchange(key, 1u, second);
  key = exchange(key, 2u, third);
  key = exchange(key, 1u, third);
  key = exchange(key, 4u, true);
  key = exchange(key, 2u, true);
  key = exchange(key, 1u, true);

  const uint ref = subgroupShuffle(low.w, key & 7u);
  const bool valid = key != REF_NONE;
  uint count = valid ? 1u : 0u;
  count += subgroupShuffleXor(count, 1u);
  count += subgroupShuffleXor(count, 2u);
  count += subgroupShuffleXor(count, 4u);
  if (count == 0u) return pop();
  incomplete = incomplete || stackSize + count - 1u > STACK;
  if (valid && lane() != 0u && !incomplete) stackRef[stackSize + count - 1u - lane()] = ref;
  memoryBarrierShared();
  stackSize = incomplete ? 0u : stackSize + count - 1u;
  return incomplete ? REF_NONE : subgroupShuffle(ref, 0u);
}

// The triangle that this lane holds of a leaf, and which lanes' triangles the frustum meets.
struct LeafTriangle {
  vec3 a, b, c;
  uint id;
};

LeafTriangle loadLeaf(Frustum f, uint ref, out uint slot, out uint meeting) {
  slot = ref & REF_INDEX_MASK;
  // Lanes beyond the leaf's end read what follows; the count of lane 0 says which they are.
  const int last = textureSize(triangleTexels) / 3 - 1;
  const int texel = min(int(slot + lane()), last) * 3;
  const uvec4 a = texelFetch(triangleTexels, texel);
  const uvec4 b = texelFetch(triangleTexels, texel + 1);
  const uvec4 c = texelFetch(triangleTexels, texel + 2);
  const LeafTriangle t = LeafTriangle(texelVec3(a), texelVec3(b), texelVec3(c), a.w);
  const vec3 pa = permute(axisOf(f), t.a - f.origin);
  const vec3 pb = permute(axisOf(f), t.b - f.origin);
  const vec3 pc = permute(axisOf(f), t.c - f.origin);
  const bool mine = lane() <= subgroupShuffle(b.w, 0u);
  const bool hit = mine && meets(f, min(pa, min(pb, pc)), max(pa, max(pb, pc)));
  meeting = orOfLanes(hit ? 1u << lane() : 0u);
  return t;
}

#endif
