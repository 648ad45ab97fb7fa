// The trace interface: R rays per invocation, and queries about them. A query is called in uniform
// control flow; rays that take no part are marked inactive. A traversal (trace/lane.glsl or
// trace/packet.glsl) defines the queries; the hits are the same to the bit.
#include "resources.glsl"

// Unrolled: lavapipe keeps arrays with constant indices in registers.
#define FOR_RAYS [[unroll]] for

const float NEVER = -3.4e38;  // depth of a ray that takes no part

// Rays origin + t * direction with tmin <= t <= tmax.
struct Rays {
  vec3 origin[R];
  vec3 direction[R];  // of any length but 0
  float tmin[R];
  float tmax[R];
  bool isActive[R];
};

// The slot of the primitive that each ray meets first, or NO_HIT.
struct Hits {
  uint slot[R];
};

// Segments from `from` to `from` + `direction`, both ends included. No direction may be 0.
struct Segments {
  vec3 from[R];
  vec3 direction[R];
  bool isActive[R];
};

// Nearest hits of any rays.
Hits closest(Rays rays);

// Nearest hits of rays that have one origin, origin[0]: those of a pinhole camera.
Hits closestFromOne(Rays rays);

// Sets clear[r] where nothing lies on segment r; false where it is inactive.
void unoccluded(Segments segments, out bool clear[R]);

// The same of segments from points to one light, which share a walk.
void unoccludedToOne(vec3 light, vec3 points[R], bool isActive[R], out bool clear[R]);

// Whether the driver has cut loops short without a word, as lavapipe does after 65,535 iterations of
// all loops of 8 lanes together: from there on each loop ends after one iteration, and this one, which
// a kernel runs last, tells. The compiler does not know how many iterations it has, nor that the one
// that ends it is the one it waits for.
bool loopsWereCut() {
  const uint wanted = 2u + (pass.region.z >> 31);
  uint iterations = 0u;
  [[dont_unroll]] while (iterations < wanted) iterations++;
  return iterations != wanted;
}
