// A background image around the scene, by latitude and longitude.
#include "texture/image.glsl"
#include "texture/angle.glsl"
#include "shared/direction.h"

vec3 backgroundAt(vec3 direction) {
  if (params.backgroundImage.width == 0u) return params.backgroundRadiance;
  const vec3 d = vec3(dotProduct(params.backgroundX, direction),
                      dotProduct(params.backgroundY, direction),
                      dotProduct(params.backgroundZ, direction));
  const float s = unitPart(turnOf(d.x, -d.z));
  const float t = 2.0 * turnOf(sqrt(d.x * d.x + d.z * d.z), d.y);
  return params.backgroundRadiance * imageAt(params.backgroundImage, s, t, false);
}

// Uniform on the sphere.
vec3 sampleBackground(vec2 numbers, out float density, out vec3 radiance) {
  density = 0.0795774715;  // 1 / 4 pi
  const vec3 direction = sphereDirection(numbers);
  radiance = backgroundAt(direction);
  return direction;
}

float backgroundDensity(vec3 direction) { return 0.0795774715; }
