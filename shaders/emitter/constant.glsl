// A background of one radiance.
#include "shared/direction.h"

vec3 backgroundAt(vec3 direction) { return params.backgroundRadiance; }

// Light sampling: a direction to the background, of unit length, its density per solid angle and its
// radiance.
vec3 sampleBackground(Source source, vec2 numbers, out float density, out vec3 radiance) {
  radiance = params.backgroundRadiance;
  density = 0.0795774715 * source.probability;  // 1 / 4 pi
  return sphereDirection(numbers);
}

// The density with which light sampling draws a direction to the background.
float backgroundDensity(vec3 direction) { return 0.0795774715 * params.backgroundProbability; }
