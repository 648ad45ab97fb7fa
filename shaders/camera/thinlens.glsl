// A thin lens: rays start at a point of the lens, uniform by area, and meet the pinhole's ray in the plane in
// focus.
#include "camera/pinhole.glsl"
#include "shared/direction.h"

const bool HAS_LENS = true;

// Relative to its centre.
vec3 lensPoint(vec2 numbers) {
  const vec2 turn = cosSinOfTurn(numbers.y);
  const float radius = sqrt(numbers.x);
  precise vec3 point = params.lensX * (radius * turn.x) + params.lensY * (radius * turn.y);
  return point;
}

vec3 cameraOrigin(vec2 film, vec2 numbers) {
  precise vec3 point = lensPoint(numbers);
  if (FAR_CAMERA) point *= params.lensAtStart;
  precise vec3 origin = pinholeOrigin(film) + point;
  return origin;
}

vec3 cameraDirection(vec2 film, vec2 numbers) {
  precise vec3 direction = pinholeDirection(film) - lensPoint(numbers) * params.lensToDirection;
  return direction;
}
