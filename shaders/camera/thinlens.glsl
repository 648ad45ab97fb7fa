// A thin lens: rays pass points of the lens that are uniform by area, and meet the pinhole's ray in the plane of
// focus. Those of far cameras start on a plane before the scene.
#include "camera/pinhole.glsl"
#include "shared/direction.h"

const bool HAS_LENS = true;

// A point on the lens, relative to its centre.
vec3 lensPoint(vec2 numbers) {
  const vec2 cosSin = cosSinOfTurn(numbers.y);
  const float radius = sqrt(numbers.x);
  precise vec3 point = params.lensX * (radius * cosSin.x) + params.lensY * (radius * cosSin.y);
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
