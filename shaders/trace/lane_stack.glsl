// The stack for one ray per invocation, of STACK entries. Loops are `do … while`: lavapipe runs one extra,
// fully masked iteration of other loops.
#include "shared/layout.h"

uint stackRef[STACK + 1u];
float stackDepth[STACK + 1u];
uint stacked;  // entries

// Pops the next reference whose node may hold a hit no farther than `last`; REF_NONE if there is none.
uint pop(float last) {
  uint ref;
  do {
    const bool some = stacked > 0u;
    stacked -= some ? 1u : 0u;
    ref = some && stackDepth[stacked] <= last ? stackRef[stacked] : REF_NONE;
  } while (stacked > 0u && ref == REF_NONE);
  return ref;
}

// Children of a node, nearest first.
struct Children {
  uint ref[NODE_WIDTH];
  float depth[NODE_WIDTH];
  uint hit;  // bit i: the ray hits child i
};

// Returns the nearest child that the ray hits and pushes the others, or pops the stack if it hits none. Stack
// writes are serialised per lane by lavapipe, so only the children that the ray hits are pushed.
uint enter(Children children, float last) {
  const uint lowest = children.hit & -children.hit;
  uint nearest = REF_NONE;
  [[unroll]] for (uint i = 0u; i < NODE_WIDTH; ++i)
    nearest = lowest == 1u << i ? children.ref[i] : nearest;

  // Pushes the farthest first. If none is left, this writes above the top of the stack.
  uint left = children.hit ^ lowest;
  do {
    uint farthest = 0u, ref = REF_NONE;
    float depth = 0.0;
    [[unroll]] for (uint i = 1u; i < NODE_WIDTH; ++i) {
      const bool hit = (left & 1u << i) != 0u;
      farthest = hit ? 1u << i : farthest;
      ref = hit ? children.ref[i] : ref;
      depth = hit ? children.depth[i] : depth;
    }
    stackRef[stacked] = ref;
    stackDepth[stacked] = depth;
    stacked += left != 0u ? 1u : 0u;
    left ^= farthest;
  } while (left != 0u);
  if (lowest == 0u) nearest = pop(last);
  return nearest;
}

// First slot of a leaf; for REF_NONE any valid slot.
uint slotOf(uint ref) { return ref == REF_NONE ? 0u : ref & REF_INDEX_MASK; }
