// What an integrator sees of tracing: R rays an invocation, two queries. Every query is called in
// uniform control flow; rays that ask nothing are marked not live.
#ifndef LAVER_RAYS
#define LAVER_RAYS
#include "shared/layout.h"

#extension GL_EXT_control_flow_attributes : require

// Loops over an invocation's rays that need no speed are kept as loops: kernels stay small.
#ifdef LAVER_PACKET
const uint R = 8;
#define FOR_RAYS [[dont_unroll]] for
#else
const uint R = 1;
#define FOR_RAYS [[unroll]] for
#endif

// Rays origin + t * direction with tmin <= t <= tmax.
struct Rays {
  vec3 origin;
  vec3 direction[R];  // of any length
  float tmin[R];
  float tmax[R];
  bool live[R];
};

// The slot of the triangle that each ray meets first, or NO_HIT.
struct Hits {
  uint slot[R];
};

// Nearest hits.
Hits closest(Rays rays);

// seen[r] = nothing lies between the light and points[r]; false where not live.
void visible(vec3 light, vec3 points[R], bool live[R], out bool seen[R]);

// The guard of both traversals: an invocation that has run too many loops, or out of stack, gives
// up and says so. working() is the condition of every loop over references. A driver may cut loops
// short without a word, lavapipe after 65,535 turns of all loops of 8 lanes together: a walk that
// ends in any other way than by an empty stack, or a blocker, is incomplete.
uint iterations = 0u;
bool incomplete = false;
bool ended = false;

bool working(uint ref) {
  iterations++;
  incomplete = incomplete || iterations >= MAX_ITERATIONS;
  return ref != REF_NONE && !incomplete;
}
uint endWalk() {
  ended = true;
  return REF_NONE;
}

#endif
