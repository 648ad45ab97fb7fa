// The trace interface: R rays per invocation, and queries about them. Queries must be called in uniform
// control flow; unused rays are marked inactive. The traversal (trace/lane.glsl or trace/packet.glsl) defines
// the queries; the hits are the same to the bit.
#include "resources.glsl"

// Unrolled: lavapipe keeps arrays with constant indices in registers.
#define FOR_RAYS [[unroll]] for

const float NEVER = -3.4e38;  // depth of an inactive ray

// Rays origin + t * direction with tmin <= t <= tmax.
struct Rays {
  vec3 origin[R];
  vec3 direction[R];  // of any length except 0
  float tmin[R];
  float tmax[R];
  bool isActive[R];
};

// The slot of the nearest primitive that each ray hits, or NO_HIT.
struct Hits {
  uint slot[R];
};

// Segments from `from` to `from` + `direction`, both ends included. Directions must not be 0.
struct Segments {
  vec3 from[R];
  vec3 direction[R];
  bool isActive[R];
};

// Nearest hits of arbitrary rays.
Hits closest(Rays rays);

// Nearest hits of rays that share the origin origin[0], such as those of a pinhole camera.
Hits closestFromOne(Rays rays);

// Sets clear[r] to whether segment r is unoccluded; false if it is inactive.
void unoccluded(Segments segments, out bool clear[R]);

// The same for segments from points to one light, which share a walk.
void unoccludedToOne(vec3 light, vec3 points[R], bool isActive[R], out bool clear[R]);

// Detects that the driver has cut loops short, as lavapipe silently does after 65,535 iterations of all loops
// of 8 lanes together: from then on each loop ends after one iteration. A kernel runs this loop last; if it
// ends early, loops were cut. The compiler cannot optimise it away, since it knows neither the number of
// iterations nor their exact end.
bool loopsWereCut() {
  const uint wanted = 2u + (pass.region.z >> 31);
  uint iterations = 0u;
  [[dont_unroll]] while (iterations < wanted) iterations++;
  return iterations != wanted;
}
