// The stack of one ray per invocation, of STACK entries. Loops are `do … while`: lavapipe runs one
// extra, fully masked iteration of other loops.
#include "shared/layout.h"

uint stackRef[STACK + 1u];
float stackDepth[STACK + 1u];
uint stacked;  // entries

// The next reference whose node can hold a hit no farther than `last`; REF_NONE if none can.
uint pop(float last) {
  uint ref;
  do {
    const bool some = stacked > 0u;
    stacked -= some ? 1u : 0u;
    ref = some && stackDepth[stacked] <= last ? stackRef[stacked] : REF_NONE;
  } while (stacked > 0u && ref == REF_NONE);
  return ref;
}

// Children of a node, the nearest first.
struct Children {
  uint ref[NODE_WIDTH];
  float depth[NODE_WIDTH];
  uint met;  // bit i: child i is to be entered
};

// The nearest child that is met; the others that are go onto the stack. Where none is, what the stack
// gives. Stack writes are serialised per lane by lavapipe, so only the
// children that the ray hits are pushed.
uint enter(Children children, float last) {
  const uint lowest = children.met & -children.met;
  uint nearest = REF_NONE;
  [[unroll]] for (uint i = 0u; i < NODE_WIDTH; ++i)
    nearest = lowest == 1u << i ? children.ref[i] : nearest;

  // The farthest first. Where none is left, this writes above the stack.
  uint left = children.met ^ lowest;
  do {
    uint farthest = 0u, ref = REF_NONE;
    float depth = 0.0;
    [[unroll]] for (uint i = 1u; i < NODE_WIDTH; ++i) {
      const bool met = (left & 1u << i) != 0u;
      farthest = met ? 1u << i : farthest;
      ref = met ? children.ref[i] : ref;
      depth = met ? children.depth[i] : depth;
    }
    stackRef[stacked] = ref;
    stackDepth[stacked] = depth;
    stacked += left != 0u ? 1u : 0u;
    left ^= farthest;
  } while (left != 0u);
  if (lowest == 0u) nearest = pop(last);
  return nearest;
}

// First slot of a leaf; of none, any.
uint slotOf(uint ref) { return ref == REF_NONE ? 0u : ref & REF_INDEX_MASK; }
