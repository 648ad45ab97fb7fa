// A disk of one radiance, infinitely far away: the directions within an angle
// of params.backgroundAxis.
#include "shared/direction.h"

// By the squared chord between direction and axis, which is accurate for small disks, too.
bool onDisk(vec3 direction) {
  const vec3 chord = unitOr(direction, vec3(0.0)) - params.backgroundAxis;
  const float versine = params.backgroundVersine;
  return versine == 2.0 || dotProduct(chord, chord) <= 2.0 * versine;
}

vec3 backgroundAt(vec3 direction) {
  return onDisk(direction) ? params.backgroundRadiance : vec3(0.0);
}

float backgroundDensity(vec3 direction) {
  // 1 / (2 pi versine)
  return onDisk(direction) ? 0.159154943 / params.backgroundVersine * params.backgroundProbability
                           : 0.0;
}

// Uniform in the cap: 1 - cosine is. Tangents as Duff et al. have them, "Building an Orthonormal Basis,
// Revisited", 2017.
vec3 sampleBackground(Source source, vec2 numbers, out float density, out vec3 radiance) {
  // Not backgroundAt(): rounding takes directions out of small disks.
  radiance = params.backgroundRadiance;
  const vec3 n = params.backgroundAxis;
  const float side = n.z < 0.0 ? -1.0 : 1.0;
  const float a = -1.0 / (side + n.z), b = n.x * n.y * a;
  const vec3 tangent = vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
  const vec3 bitangent = vec3(b, side + n.y * n.y * a, -n.y);
  const float below = numbers.x * params.backgroundVersine;
  const float radius = sqrt(below * (2.0 - below));
  const vec2 turn = cosSinOfTurn(numbers.y);
  density = 0.159154943 / params.backgroundVersine * source.probability;
  return tangent * (turn.x * radius) + bitangent * (turn.y * radius) + n * (1.0 - below);
}
