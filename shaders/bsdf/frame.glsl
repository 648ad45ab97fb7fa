// Frames about a normal.
#include "shared/point.h"

// A direction across n, of some length: Nori's frames have it as x.
vec3 acrossNormal(vec3 n) {
  const vec3 y = abs(n.x) > abs(n.y) ? vec3(n.z, 0.0, -n.x) : vec3(0.0, n.z, -n.y);
  return crossProduct(y, n);
}

// The unit vector across n along a tangent of any length; one as in Nori where that is 0.
vec3 frameX(vec3 n, vec3 tangent) {
  return unitOr(tangent - n * dotProduct(n, tangent), unitOr(acrossNormal(n), n));
}
