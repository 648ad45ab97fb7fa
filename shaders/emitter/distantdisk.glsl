// A disk of one radiance, infinitely far away: the directions within an angle of params.backgroundZ.
#include "shared/direction.h"

bool onDisk(vec3 direction) {
  return dotProduct(params.backgroundZ, unitOr(direction, vec3(0.0))) >= params.backgroundCosine;
}

vec3 backgroundAt(vec3 direction) {
  return onDisk(direction) ? params.backgroundRadiance : vec3(0.0);
}

float backgroundDensity(vec3 direction) {
  return onDisk(direction) ? 0.159154943 / (1.0 - params.backgroundCosine) : 0.0;  // 1 / 2 pi
}

// Uniform in the cap: 1 - cosine is. Tangents as Duff et al. have them, "Building an Orthonormal Basis,
// Revisited", 2017.
vec3 sampleBackground(vec2 numbers, out float density) {
  const vec3 n = params.backgroundZ;
  const float side = n.z < 0.0 ? -1.0 : 1.0;
  const float a = -1.0 / (side + n.z), b = n.x * n.y * a;
  const vec3 tangent = vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
  const vec3 bitangent = vec3(b, side + n.y * n.y * a, -n.y);
  const float below = numbers.x * (1.0 - params.backgroundCosine);
  const float radius = sqrt(below * (2.0 - below));
  const vec2 turn = cosSinOfTurn(numbers.y);
  density = 0.159154943 / (1.0 - params.backgroundCosine);
  return tangent * (turn.x * radius) + bitangent * (turn.y * radius) + n * (1.0 - below);
}
