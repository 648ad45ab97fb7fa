// What an integrator sees of tracing: R rays an invocation, two queries. Every query is called in
// uniform control flow; rays that ask nothing are marked not live.
#ifndef LAVER_RAYS
#define LAVER_RAYS

const uint R = 1;  // lane traversal

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

// visible[r] = nothing lies between the light and points[r]; false where not live.
void visible(vec3 light, vec3 points[R], bool live[R], out bool seen[R]);

#endif
