// Box tests for the chart: two common ones on tight boxes, and laver's on grown boxes.
#include "shared/box.h"
#include "shared/charted.h"

struct WalkRay {
  Shear shear;
  BoxRay box;
  vec3 origin, inverse;
  uint octant;
  float scale;  // largest |component| of the direction
  float first;  // depth at tmin
};

WalkRay walkRay(vec3 origin, vec3 direction, float tmin) {
  WalkRay ray;
  ray.shear = shearOf(direction);
  ray.box = boxRayOf(origin, direction, ray.shear.axis);
  ray.origin = origin;
  ray.scale = abs(alongAxis(direction, ray.shear.axis));
  // Divided by the scale, so that all box tests give depths.
  ray.inverse = ray.scale / direction;
  ray.octant = (direction.x < 0.0 ? 1u : 0u) | (direction.y < 0.0 ? 2u : 0u) |
               (direction.z < 0.0 ? 4u : 0u);
  ray.first = tmin * ray.scale;
  return ray;
}

BoxSpan boxOf(WalkRay ray, vec3 lo, vec3 hi) {
  if (BOXES == BOXES_OURS) return boxSpan(ray.box, ray.first, lo, hi);
  const vec3 t0 = (lo - ray.origin) * ray.inverse;
  const vec3 t1 = (hi - ray.origin) * ray.inverse;
  const vec3 enter = min(t0, t1), leave = max(t0, t1);
  BoxSpan span;
  span.near = max(max(enter.x, enter.y), max(enter.z, ray.first));
  span.far = min(leave.x, min(leave.y, leave.z));
  if (BOXES == BOXES_ROBUST) span.far *= 1.00000024;  // 1 + 2 gamma(3)
  span.depth = span.near;
  return span;
}
