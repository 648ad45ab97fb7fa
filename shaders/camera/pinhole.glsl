// Origin and direction of the pinhole's ray through a film position given in pixels.
#include "resources.glsl"

// Of a far camera on the plane where its rays start.
vec3 pinholeOrigin(vec2 film) {
  if (!FAR_CAMERA) return params.origin;
  precise float x = float(params.filmSize.x) - 2.0 * film.x;
  precise float y = float(params.filmSize.y) - 2.0 * film.y;
  precise vec3 o = params.startX * x + params.startY * y + params.origin;
  return o;
}

vec3 pinholeDirection(vec2 film) {
  precise float x = float(params.filmSize.x) - 2.0 * film.x;
  precise float y = float(params.filmSize.y) - 2.0 * film.y;
  precise vec3 d = params.columnX * x + params.columnY * y + params.columnZ;
  return d;
}
