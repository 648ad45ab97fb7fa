// Angles as fractions of a full turn.
#include "shared/triangle.h"

// The angle of (x, y) from +x towards +y as a fraction of a full turn, in [-1/2, 1/2]; 0 at (0, 0). Within 4
// ulp of 1/2; a driver's own may be off by 4096 ulp. The angle to the nearest multiple of 1/8 turn has a
// tangent of at most tan(pi/8), for which the polynomial's minimax error is 2e-8.
float turnOf(float y, float x) {
  const bool steep = abs(y) > abs(x);
  const float large = chosen(steep, abs(y), abs(x));
  const float small = chosen(steep, abs(x), abs(y));
  const bool diagonal = small > 0.41421357 * large;
  const float opposite = chosen(diagonal, small - large, small);
  const float adjacent = chosen(diagonal, small + large, large);
  const float q = chosen(adjacent > 0.0, opposite / adjacent, 0.0);
  const float z = q * q;
  const float p =
      ((0.080603085 * z - 0.1387985) * z + 0.19977926) * z - 0.33332956;
  const float eighths = (q + q * z * p) * 0.15915494 + (diagonal ? 0.125 : 0.0);
  const float quarter = chosen(steep, 0.25 - eighths, eighths);
  const float halves = chosen(x < 0.0, 0.5 - quarter, quarter);
  return chosen(y < 0.0, -halves, halves);
}
