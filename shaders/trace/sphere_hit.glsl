// The hit point on a sphere, for surfaces and layers.
#include "shared/sphere.h"
#include "texture/angle.glsl"

// u = 1/2 + atan2(y, x) / 2 pi and v = 1/2 + asin(z) / pi of the normal; that asin is the angle of
// (hypot(x, y), z), which loses no digits near the poles.
vec2 uvOnSphere(vec3 n) {
  return vec2(0.5 + turnOf(n.y, n.x), 0.5 + 2.0 * turnOf(n.z, sqrt(n.x * n.x + n.y * n.y)));
}

// The hit with u and v as the weights of the second and third corner, as in triangles without texture
// coordinates.
Point sphereHitAt(vec3 origin, vec3 direction, float tmin, vec3 centre, float radius) {
  Point p = spherePointAt(origin, direction, tmin, centre, radius);
  p.weights = vec3(0.0, uvOnSphere(p.geometric));
  return p;
}
