// Watertight ray/triangle test (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection",
// JCGT 2(1), 2013) with Kahan's difference of products (Jeannerod, Louvet and Muller, "Further
// Analysis of Kahan's Algorithm ...", Math. Comp. 82, 2013: 1.5 ulp) instead of plain products, so
// that edge functions keep their sign on devices with a fused fma. Where fma is a product and a
// sum, the correction is zero, and both triangles of an edge still round alike.
#ifndef LAVER_SHARED_TRIANGLE_H
#define LAVER_SHARED_TRIANGLE_H
#include "shared/types.h"

LAVER_SHARED_BEGIN

// min and max that compile to one instruction; the result is b if a is NaN.
LAVER_FN float lesser(float a, float b) {
  LAVER_PRECISE float result = a < b ? a : b;
  return result;
}
LAVER_FN float greater(float a, float b) {
  LAVER_PRECISE float result = a > b ? a : b;
  return result;
}

// a * b - c * d.
LAVER_FN float differenceOfProducts(float a, float b, float c, float d) {
  LAVER_PRECISE float product = c * d;
  LAVER_PRECISE float error = fma(-c, d, product);
  LAVER_PRECISE float difference = fma(a, b, -product);
  LAVER_PRECISE float result = difference + error;
  return result;
}

LAVER_FN vec3 crossProduct(vec3 a, vec3 b) {
  return vec3(differenceOfProducts(a.y, b.z, a.z, b.y), differenceOfProducts(a.z, b.x, a.x, b.z),
              differenceOfProducts(a.x, b.y, a.y, b.x));
}

LAVER_FN float dotProduct(vec3 a, vec3 b) {
  LAVER_PRECISE float result = a.x * b.x + a.y * b.y + a.z * b.z;
  return result;
}

// A direction as its dominant axis k (ties: x before y before z), the sign along k, and the slopes
// of the two other axes relative to k. "Depth" below is the distance along k, positive ahead of the
// origin.
struct Shear {
  uint axis;
  float sign;
  float u, v;
};

// A selection between two numbers that are both known: one instruction, while `?:` between
// expressions makes two branches. SwiftShader's compiler takes twice the time and memory for each
// such pair of branches that follows another one within a loop.
LAVER_FN float chosen(bool first, float a, float b) { return first ? a : b; }

LAVER_FN float alongAxis(vec3 p, uint axis) {
  return chosen(axis == 0u, p.x, chosen(axis == 1u, p.y, p.z));
}

// (u, v, depth) of p - origin.
LAVER_FN vec3 permute(Shear shear, vec3 p) {
  return vec3(chosen(shear.axis == 0u, p.y, p.x), chosen(shear.axis == 2u, p.y, p.z),
              alongAxis(p, shear.axis) * shear.sign);
}

LAVER_FN Shear shearOf(vec3 d) {
  Shear shear;
  float x = abs(d.x), y = abs(d.y), z = abs(d.z);
  shear.axis = (x >= y && x >= z) ? 0u : (y >= z ? 1u : 2u);
  shear.sign = alongAxis(d, shear.axis) < 0.0f ? -1.0f : 1.0f;
  shear.u = 0.0f;
  shear.v = 0.0f;
  LAVER_PRECISE vec3 q = permute(shear, d);
  LAVER_PRECISE float u = q.x / q.z;
  LAVER_PRECISE float v = q.y / q.z;
  shear.u = u;
  shear.v = v;
  return shear;
}

// Edge functions for corners that are permuted and relative to the origin.
struct Edges {
  float a, b, c;  // their signs agree inside; a / (a + b + c) is the weight of corner a
  float sum;
  bool inside;  // edges included
};

LAVER_FN Edges edgesOf(Shear shear, vec3 a, vec3 b, vec3 c) {
  LAVER_PRECISE float ax = a.x - shear.u * a.z;
  LAVER_PRECISE float ay = a.y - shear.v * a.z;
  LAVER_PRECISE float bx = b.x - shear.u * b.z;
  LAVER_PRECISE float by = b.y - shear.v * b.z;
  LAVER_PRECISE float cx = c.x - shear.u * c.z;
  LAVER_PRECISE float cy = c.y - shear.v * c.z;
  Edges e;
  e.a = differenceOfProducts(cx, by, cy, bx);
  e.b = differenceOfProducts(ax, cy, ay, cx);
  e.c = differenceOfProducts(bx, ay, by, ax);
  LAVER_PRECISE float sum = e.a + e.b + e.c;
  e.sum = sum;
  // All of them >= 0 or all <= 0, and not all zero; false if one is NaN.
  float low = lesser(e.a, lesser(e.b, e.c));
  float high = greater(e.a, greater(e.b, e.c));
  e.inside = (low >= 0.0f || high <= 0.0f) && abs(sum) > 0.0f;
  return e;
}

// Depth of a hit, from the edge functions: a mean of the corners' depths, clamped between them. A
// box that starts behind a hit therefore holds no nearer one, whatever rounding did, and pruning by
// depth never changes which hit wins.
LAVER_FN float depthOf(Edges e, float az, float bz, float cz) {
  LAVER_PRECISE float depth = (e.a * az + e.b * bz + e.c * cz) / e.sum;
  return greater(lesser(az, lesser(bz, cz)), lesser(depth, greater(az, greater(bz, cz))));
}

// Whether a triangle blocks the segment from a point to a light. Everything is permuted for the
// line from the point to the light: corners relative to the point, `normal` of any length, and
// `lightSide` = normal . (light - a). It blocks if the edge test passes on the line and the two
// ends lie on different sides of the plane. Depths are only compared with `last`, the light's own,
// as for boxes, so that the answer does not depend on the tree. No distance of a hit is compared:
// its error would grow with the light's distance.
LAVER_FN bool blocks(Shear shear, float last, vec3 normal, float lightSide, vec3 a, vec3 b,
                     vec3 c) {
  Edges e = edgesOf(shear, a, b, c);
  float side = dotProduct(normal, a);  // of the point, negated
  bool apart = (lightSide > 0.0f && side > 0.0f) || (lightSide < 0.0f && side < 0.0f);
  return e.inside && apart && lesser(a.z, lesser(b.z, c.z)) <= last &&
         greater(a.z, greater(b.z, c.z)) >= 0.0f;
}

// The same for the segment from a point to point + direction, `direction` permuted. Without a
// light, the side of the end is computed relative to the point, so that a short segment is as exact
// as a long one.
LAVER_FN bool blocksSegment(Shear shear, float last, vec3 direction, vec3 normal, vec3 a, vec3 b,
                            vec3 c) {
  LAVER_PRECISE float endSide = dotProduct(normal, direction) - dotProduct(normal, a);
  return blocks(shear, last, normal, endSide, a, b, c);
}

LAVER_SHARED_END

#endif
