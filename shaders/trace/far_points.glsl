// Shadow rays of points that are far from the centre of device coordinates.
#include "shared/triangle.h"

float largestAxis(vec3 p) { return greater(abs(p.x), greater(abs(p.y), abs(p.z))); }

// A ray errs by e = 2^-24 of the distance from its origin. If the point is much farther from the centre
// than the light, geometry near the centre is near the light: the ray is then traced from the light, and
// geometry near the point is decided by the sides of planes (blocks()). In scenes without far parts this is
// never the case: points lie in [-1, 1]^3.
bool isFarPoint(vec3 point, vec3 light) {
  return largestAxis(point) > 4.0 * greater(largestAxis(light), 1.0);
}
