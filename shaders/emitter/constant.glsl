// A background of one radiance.
#include "shared/direction.h"

vec3 backgroundAt(vec3 direction) { return params.backgroundRadiance; }

// A direction to the background, of unit length, its density per solid angle and its radiance.
vec3 sampleBackground(vec2 numbers, out float density, out vec3 radiance) {
  radiance = params.backgroundRadiance;
  density = 0.0795774715;  // 1 / 4 pi
  return sphereDirection(numbers);
}

float backgroundDensity(vec3 direction) { return 0.0795774715; }
