// Caps: spheres of which only a small part is near, such as a planet under a camera. Floats hold
// neither the centre nor the radius of such a sphere to the accuracy of what is seen. So it is
// given by its point nearest to the centre of device coordinates, its outward normal there, and its
// curvature k = 1 / radius. A point at f from the nearest point lies on the sphere where
//   n . f + k/2 f . f = 0,
// and outside where this is positive. Every term is of the order of |f|, so that rounding errors
// are relative to the distance from the camera.
#ifndef LAVER_SHARED_CAP_H
#define LAVER_SHARED_CAP_H
#include "shared/point.h"
#include "shared/sphere.h"

LAVER_SHARED_BEGIN

struct Cap {
  vec3 nearest, normal;
  float curvature;
};

LAVER_FN Cap capOf(vec3 a, vec3 b, vec3 c) {
  Cap cap;
  cap.nearest = a;
  cap.normal = b;
  cap.curvature = c.x;
  return cap;
}

// Signed distance from the sphere to first order, positive outside; `f` is relative to `nearest`.
LAVER_FN float heightOver(Cap cap, vec3 f) {
  LAVER_PRECISE float height = dotProduct(cap.normal, f) + 0.5f * cap.curvature * dotProduct(f, f);
  return height;
}

LAVER_FN vec3 gradientAt(Cap cap, vec3 f) {
  LAVER_PRECISE vec3 gradient = cap.normal + f * cap.curvature;
  return gradient;
}

// Where a line f + t d crosses the sphere: roots of a quadratic equation, neither by a difference
// that cancels.
struct CapCrossings {
  float first, middle, second;
  bool hit;
};

LAVER_FN CapCrossings crossingsOf(Cap cap, vec3 f, vec3 d) {
  LAVER_PRECISE float a = 0.5f * cap.curvature * dotProduct(d, d);
  const float b = dotProduct(gradientAt(cap, f), d);
  const float c = heightOver(cap, f);
  const float discriminant = differenceOfProducts(b, b, 4.0f * a, c);
  const float root = sqrt(greater(discriminant, 0.0f));
  LAVER_PRECISE float q = -0.5f * (b + (b < 0.0f ? -root : root));
  LAVER_PRECISE float one = q / a;
  LAVER_PRECISE float other = q != 0.0f ? c / q : one;
  CapCrossings at;
  at.first = lesser(one, other);
  at.second = greater(one, other);
  LAVER_PRECISE float middle = -0.5f * b / a;
  at.middle = middle;
  at.hit = discriminant >= 0.0f;
  return at;
}

// t of the hit of a ray that begins at tmin: where it enters, or leaves if it begins inside.
LAVER_FN float hitOn(CapCrossings at, float tmin) {
  return at.first >= tmin ? at.first : at.second;
}

// Whether a cap blocks the segment between two points. Their sides decide, as in sphereBlocks().
LAVER_FN bool capBlocks(Cap cap, vec3 from, vec3 end) {
  const vec3 f = from - cap.nearest;
  const bool begins = heightOver(cap, f) > 0.0f;
  const bool leaves = heightOver(cap, end - cap.nearest) > 0.0f;
  const CapCrossings at = crossingsOf(cap, f, end - from);
  return begins != leaves || (begins && at.hit && at.middle > 0.0f && at.middle < 1.0f);
}

// The hit point, recomputed once. `weights` are meaningless.
LAVER_FN Point capPointAt(vec3 origin, vec3 direction, float tmin, Cap cap) {
  const vec3 f = origin - cap.nearest;
  const CapCrossings at = crossingsOf(cap, f, direction);
  const float t = hitOn(at, tmin);
  // A step of Newton's method along the ray, then one along the normal.
  LAVER_PRECISE vec3 before = f + direction * t;
  const float speed = dotProduct(gradientAt(cap, before), direction);
  const float limit = 0.25f * (at.second - at.first);
  const float moved =
      speed != 0.0f ? clamped(-limit, heightOver(cap, before) / speed, limit) : 0.0f;
  LAVER_PRECISE float nearer = t - moved;
  LAVER_PRECISE vec3 beside = f + direction * nearer;
  Point point;
  point.t = nearer;
  point.geometric = unitOr(gradientAt(cap, beside), cap.normal);
  LAVER_PRECISE vec3 on = beside - point.geometric * heightOver(cap, beside);
  LAVER_PRECISE vec3 position = cap.nearest + on;
  point.position = position;
  point.weights = vec3(1.0f, 0.0f, 0.0f);
  // With e = 2^-24: heightOver() errs by 4 e of its terms, on either side of the step; the sum by e
  // |position| on each axis; 16 e leaves room for the rounding of the offset origin.
  const vec3 tilt = vec3(abs(point.geometric.x), abs(point.geometric.y), abs(point.geometric.z));
  const vec3 size = vec3(abs(cap.nearest.x) + abs(on.x), abs(cap.nearest.y) + abs(on.y),
                         abs(cap.nearest.z) + abs(on.z));
  point.offset = 9.5367432e-7f * dotProduct(tilt, size);
  return point;
}

LAVER_SHARED_END

#endif
