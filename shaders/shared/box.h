// Conservative ray/box test: it accepts every box whose contents the triangle test can accept. The
// slab method (Kay and Kajiya 1986), with boxes that the host has grown by an ulp and an origin
// that is moved sideways by a pad.
#ifndef LAVER_SHARED_BOX_H
#define LAVER_SHARED_BOX_H
#include "shared/triangle.h"

LAVER_SHARED_BEGIN

struct BoxRay {
  vec3 low, high;   // origin moved by the pad against each side of a box
  vec3 reciprocal;  // depth gained per unit along each of the three axes
  uint axis;
};

// d[k]| / d[a], but never infinite. A slope below 2^-100 does not move a ray visibly.
LAVER_FN float depthPerUnit(float d, float scale) {
  const float huge = 1.2676506e30f;  // 2^100
  const float q = abs(d) * huge > scale ? scale / d : huge;
  return chosen(abs(d) * huge > scale || d >= 0.0f, q, -q);
}

// Sideways padding. The triangle test can accept a line that passes a triangle by its own rounding.
// With e = 2^-24 and A = |o| + |v| >= |v - o|, by largest components, v the triangle's farthest
// corner: corner - origin errs by e A on two axes, the slope by 5 e (2.5 ulp a division), shear
// product and difference by 2 e A, the edge functions by 3 e A, and a box test, be it of a ray or
// of a frustum, by 4 e A: below 16 e A in all. The host grows each triangle's box by BOX_GROWTH
// |v|, which suffices for shadow rays from a light, too (packet_unoccluded.glsl); the ray's pad is
// the part of |o|. Along k no pad is needed: corners lie within the box, subtraction rounds
// monotonically and depthOf() stays between the corners' depths.
LAVER_CONST float BOX_GROWTH = 32.0f * 5.9604645e-8f;

LAVER_FN float padOf(vec3 origin) {
  return 9.5367432e-7f * greater(abs(origin.x), greater(abs(origin.y), abs(origin.z)));
}

// Does a line pass the box around three permuted corners, relative to its origin? A short edge far
// beside the line has an edge function that is rounding alone where products are not fused, and a
// triangle that is seen along its length from far away two more, so that the triangle test might
// accept what only boxes keep out. Every hit passes, with the 16 e of padOf().
LAVER_FN bool passesCorners(Shear shear, vec3 a, vec3 b, vec3 c) {
  LAVER_PRECISE vec3 x = vec3(a.x, b.x, c.x) - shear.u * vec3(a.z, b.z, c.z);
  LAVER_PRECISE vec3 y = vec3(a.y, b.y, c.y) - shear.v * vec3(a.z, b.z, c.z);
  const vec3 size = vec3(greater(abs(a.x), greater(abs(a.y), abs(a.z))),
                         greater(abs(b.x), greater(abs(b.y), abs(b.z))),
                         greater(abs(c.x), greater(abs(c.y), abs(c.z))));
  const float pad = 9.5367432e-7f * greater(size.x, greater(size.y, size.z));
  return lesser(x.x, lesser(x.y, x.z)) <= pad && greater(x.x, greater(x.y, x.z)) >= -pad &&
         lesser(y.x, lesser(y.y, y.z)) <= pad && greater(y.x, greater(y.y, y.z)) >= -pad;
}

// Relative slack for the rounding of a difference along k, two ulp, so that a segment reaches
// geometry at exactly the depth of its end.
LAVER_CONST float DEPTH_SLACK = 1.0f + 2.4e-7f;

LAVER_FN BoxRay boxRayOf(vec3 origin, vec3 direction, uint axis) {
  const float scale = abs(alongAxis(direction, axis));
  const float pad = padOf(origin);
  const vec3 padding =
      vec3(axis == 0u ? 0.0f : pad, axis == 1u ? 0.0f : pad, axis == 2u ? 0.0f : pad);
  BoxRay ray;
  ray.low = origin + padding;
  ray.high = origin - padding;
  ray.reciprocal = vec3(depthPerUnit(direction.x, scale), depthPerUnit(direction.y, scale),
                        depthPerUnit(direction.z, scale));
  ray.axis = axis;
  return ray;
}

// The ray is inside the box from depth `near` to `far`; `depth` is where it enters along k. It
// misses the box where near > far.
struct BoxSpan {
  float depth, near, far;
};

LAVER_FN BoxSpan boxSpan(BoxRay ray, float first, vec3 lo, vec3 hi) {
  LAVER_PRECISE vec3 t0 = (lo - ray.low) * ray.reciprocal;
  LAVER_PRECISE vec3 t1 = (hi - ray.high) * ray.reciprocal;
  const vec3 enter = vec3(lesser(t0.x, t1.x), lesser(t0.y, t1.y), lesser(t0.z, t1.z));
  const vec3 leave = vec3(greater(t0.x, t1.x), greater(t0.y, t1.y), greater(t0.z, t1.z));
  BoxSpan span;
  span.depth = alongAxis(enter, ray.axis);
  span.near = greater(greater(enter.x, enter.y), greater(enter.z, first));
  span.far = lesser(leave.x, lesser(leave.y, leave.z));
  return span;
}

LAVER_SHARED_END

#endif
