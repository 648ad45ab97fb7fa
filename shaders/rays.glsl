// What an integrator sees of tracing: R rays an invocation, two queries. Every query is called in
// uniform control flow; rays that ask nothing are marked not live.
#ifndef LAVER_RAYS
#define LAVER_RAYS
#include "resources.glsl"

#extension GL_EXT_control_flow_attributes : require

#ifdef LAVER_PACKET
const uint R = LAVER_PACKET / 8u;  // 8 or 4
#else
const uint R = 1;
#endif
// Unrolled: lavapipe keeps arrays with constant indices in registers.
#define FOR_RAYS [[unroll]] for

const float NEVER = -3.4e38;  // depth of a ray that takes no part

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

// clear[r] = nothing lies between points[r] and points[r] + ways[r]; false where not live. No way
// may be zero.
void unoccluded(vec3 points[R], vec3 ways[R], bool live[R], out bool clear[R]);

// Whether the driver has cut loops short without a word, as lavapipe does after 65,535 turns of all
// loops of 8 lanes together: from there on each loop ends after a turn, and this one, which a kernel
// runs last, tells. The compiler does not know how often it turns, nor, with another comparison, that
// the one which ends it is the one asked for.
bool loopsWereCut() {
  const uint wanted = 2u + (pass.region.z >> 31);
  uint turns = 0u;
  [[dont_unroll]] while (turns < wanted) turns++;
  return turns != wanted;
}

#endif
