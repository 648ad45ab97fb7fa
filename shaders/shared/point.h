// The hit point of a ray, recomputed once from the corners of the triangle that was hit. The
// kernels and the C++ tests compile this same text.
#ifndef LAVER_SHARED_POINT_H
#define LAVER_SHARED_POINT_H
#include "shared/triangle.h"

LAVER_SHARED_BEGIN

struct Point {
  vec3 position;   // by barycentrics: on the triangle up to rounding, however far the camera is
  vec3 geometric;  // unit normal by the winding and `flipped`; -direction if the area is 0
  float t;         // ray parameter, from the plane equation
  float offset;    // distance along the geometric normal by which a ray's origin is offset
  vec3 weights;    // barycentric coordinates
};

// The upper 12 bits of a float's 24; the rest, x - upperHalf(x), has 12 bits too.
LAVER_FN float upperHalf(float x) { return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u); }

// a * b - c * d with an error of at most two ulp of the result plus 2^-35 of the products, on any
// device; differenceOfProducts() is as good only with a fused fma(). Products of halves (Dekker, "A
// Floating-Point Technique for Extending the Available Precision", 1971) are exact, so contraction
// does not change a bit, and the large ones cancel exactly.
LAVER_FN float accurateDifference(float a, float b, float c, float d) {
  const float ah = upperHalf(a), bh = upperHalf(b), ch = upperHalf(c), dh = upperHalf(d);
  LAVER_PRECISE float al = a - ah;
  LAVER_PRECISE float bl = b - bh;
  LAVER_PRECISE float cl = c - ch;
  LAVER_PRECISE float dl = d - dh;
  LAVER_PRECISE float middle = (ah * bl - ch * dl) + (al * bh - cl * dh);
  LAVER_PRECISE float result = (ah * bh - ch * dh) + (middle + (al * bl - cl * dl));
  return result;
}

// a x b. t depends on the plane's normal: for a sliver of aspect ratio 1e4, t errs by 160 ulp with
// plain products.
LAVER_FN vec3 accurateCross(vec3 a, vec3 b) {
  return vec3(accurateDifference(a.y, b.z, a.z, b.y), accurateDifference(a.z, b.x, a.x, b.z),
              accurateDifference(a.x, b.y, a.y, b.x));
}

// v / |v|, free of overflow and underflow; `otherwise` where v is zero.
LAVER_FN vec3 unitOr(vec3 v, vec3 otherwise) {
  const float m = max(abs(v.x), max(abs(v.y), abs(v.z)));
  const vec3 s = v / (m > 0.0f ? m : 1.0f);
  const vec3 unit = s / sqrt(dotProduct(s, s));
  return m > 0.0f ? unit : otherwise;
}

LAVER_FN float largestOf(float a, float b, float c) { return max(abs(a), max(abs(b), abs(c))); }

// Only for hits that edgesOf() accepts. The direction has any length; `flipped` reverses the
// normal.
LAVER_FN Point pointAt(vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c, bool flipped) {
  const Shear shear = shearOf(direction);
  const vec3 pa = permute(shear, a - origin);
  const vec3 pb = permute(shear, b - origin);
  const vec3 pc = permute(shear, c - origin);
  const Edges e = edgesOf(shear, pa, pb, pc);
  LAVER_PRECISE float wa = e.a / e.sum;
  LAVER_PRECISE float wb = e.b / e.sum;
  LAVER_PRECISE float wc = e.c / e.sum;

  Point p;
  LAVER_PRECISE vec3 position = a + ((b - a) * wb + (c - a) * wc);
  p.position = position;
  p.weights = vec3(wa, wb, wc);
  const vec3 n = accurateCross(b - a, c - a) * (flipped ? -1.0f : 1.0f);
  p.geometric = unitOr(n, unitOr(-direction, vec3(0.0f, 0.0f, 1.0f)));

  // The depth of the plane along the ray, or that of the edge functions where the plane is seen
  // edge-on; either is clamped to the depths of the corners.
  const float across = dotProduct(n, direction);
  const float scale = abs(alongAxis(direction, shear.axis));
  const float nearest = min(pa.z, min(pb.z, pc.z)), farthest = max(pa.z, max(pb.z, pc.z));
  const float depth =
      across != 0.0f ? dotProduct(n, a - origin) / across * scale : depthOf(e, pa.z, pb.z, pc.z);
  p.t = max(nearest, min(depth, farthest)) / scale;

  // 8 e (|g| . max |corner|), with e = 2^-24, g the unit normal, |.| and max per component.
  // `position` is off its plane by e |position| and 3 e of its distance from a, on each axis; the
  // rest covers the dot products of the plane-side test.
  const vec3 largest =
      vec3(largestOf(a.x, b.x, c.x), largestOf(a.y, b.y, c.y), largestOf(a.z, b.z, c.z));
  const vec3 tilt = vec3(abs(p.geometric.x), abs(p.geometric.y), abs(p.geometric.z));
  p.offset = 4.7683716e-7f * dotProduct(tilt, largest);
  return p;
}

// The shading normal at `p`, interpolated from the vertex normals of its corners.
LAVER_FN vec3 shadingNormal(Point p, vec3 na, vec3 nb, vec3 nc) {
  LAVER_PRECISE vec3 m = na * p.weights.x + nb * p.weights.y + nc * p.weights.z;
  // A weighted sum of unit normals that is shorter than 2^-22 is only rounding error.
  return dotProduct(m, m) > 5.7e-14f ? unitOr(m, p.geometric) : p.geometric;
}

LAVER_SHARED_END

#endif
