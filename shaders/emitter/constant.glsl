// A background of one radiance.
#include "shared/direction.h"

vec3 backgroundAt(vec3 direction) { return params.backgroundRadiance; }

// A direction to the background, of unit length, and its density per solid angle.
vec3 sampleBackground(vec2 numbers, out float density) {
  density = 0.0795774715;  // 1 / 4 pi
  return sphereDirection(numbers);
}

float backgroundDensity(vec3 direction) { return 0.0795774715; }
