// The direction through a film position given in pixels.
#include "resources.glsl"

vec3 pinholeDirection(vec2 film) {
  precise float x = float(params.filmSize.x) - 2.0 * film.x;
  precise float y = float(params.filmSize.y) - 2.0 * film.y;
  precise vec3 d = params.columnX * x + params.columnY * y + params.columnZ;
  return d;
}
