// Ray/sphere test in the same terms as the triangle test (triangle.h): sheared, with depths along
// the ray's dominant axis, so that one walk, one kind of box and one rule for equal depths serve
// both.
#ifndef LAVER_SHARED_SPHERE_H
#define LAVER_SHARED_SPHERE_H
#include "shared/box.h"
#include "shared/point.h"

LAVER_SHARED_BEGIN

// Depths at which a line enters and leaves a sphere, and the depth of its point nearest the centre.
struct Chord {
  float near, middle, far;
  bool hit;
};

// The power of two that scales a radius between 2^-100 and 1 into [1, 2).
LAVER_FN float scaleToUnit(float radius) {
  return uintBitsToFloat((254u << 23) - (floatBitsToUint(radius) & 0x7f800000u));
}

LAVER_FN float clamped(float low, float x, float high) { return greater(low, lesser(x, high)); }

// Depths of a sphere's front and back, from the permuted depths of its centre and of the origin.
// The order of the roundings is that of box bounds, so that the ends never lie outside of the
// sphere's box.
LAVER_FN vec2 endsOf(float centre, float radius, float origin) {
  LAVER_PRECISE vec2 ends = vec2(centre - radius, centre + radius);
  LAVER_PRECISE vec2 result = ends - origin;
  return result;
}

// `centre` is permuted and relative to the origin.
//
// With S the vector from the line to the centre at the centre's own depth and D = (u, v, 1), the
// line passes the centre at distance |S x D| / |D|. That is a root of a sum of squares, in which
// nothing cancels, so that far and small spheres keep their outline, which b^2 - ac loses (Haines,
// Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing
// Gems, 2019). Roundings: S by 8 e A as in padOf(), which the pad covers; squares, sum and |D|^2 by
// 5 e radius, which the growth of the box covers (SPHERE_GROWTH).
LAVER_FN Chord chordOf(Shear shear, vec3 centre, vec2 ends, float radius) {
  const float scale = scaleToUnit(radius);
  LAVER_PRECISE float sx = centre.x - shear.u * centre.z;
  LAVER_PRECISE float sy = centre.y - shear.v * centre.z;
  LAVER_PRECISE float along = 1.0f + (shear.u * shear.u + shear.v * shear.v);
  const float x = clamped(-1e9f, sx * scale, 1e9f), y = clamped(-1e9f, sy * scale, 1e9f);
  LAVER_PRECISE float cross = x * shear.v - y * shear.u;
  LAVER_PRECISE float apart = x * x + y * y + cross * cross;
  const float unit = radius * scale;
  LAVER_PRECISE float left = unit * unit * along - apart;
  LAVER_PRECISE float halfChord = sqrt(greater(left, 0.0f)) / along / scale;
  LAVER_PRECISE float middle = centre.z + (shear.u * sx + shear.v * sy) / along;
  Chord chord;
  chord.middle = middle;
  // Clamped between the ends, like depthOf() between corners: pruning by depth never changes which
  // hit wins.
  chord.near = clamped(ends.x, middle - halfChord, ends.y);
  chord.far = clamped(ends.x, middle + halfChord, ends.y);
  chord.hit = left >= 0.0f;
  return chord;
}

// Factor on the radius for a sphere's box: the 5 e of chordOf(), rounded up.
LAVER_CONST float SPHERE_GROWTH = 1.0f + 8.0f * 5.9604645e-8f;

// Depth of the hit of a ray that begins at depth `first`: where it enters the sphere, or leaves it
// if it begins inside.
LAVER_FN float depthOn(Chord chord, float first) {
  return chord.near >= first ? chord.near : chord.far;
}

// Whether a point, given relative to the centre, is outside the sphere.
LAVER_FN bool outside(vec3 point, float radius) {
  const float scale = scaleToUnit(radius);
  const vec3 p = vec3(clamped(-1e9f, point.x * scale, 1e9f), clamped(-1e9f, point.y * scale, 1e9f),
                      clamped(-1e9f, point.z * scale, 1e9f));
  LAVER_PRECISE float unit = radius * scale * (radius * scale);
  return dotProduct(p, p) > unit;
}

// Whether a sphere blocks the segment from a point to an end. `centre` is relative to the point,
// `end` to the centre, both permuted. If one of the two is inside and the other outside, it does.
// If both are inside, it does not, since spheres are hollow. If both are outside, it does if the
// line's point nearest the centre lies between them. No distance of a hit is compared, as with
// triangles (blocks()).
LAVER_FN bool sphereBlocks(Shear shear, float last, vec3 centre, vec3 end, vec2 ends,
                           float radius) {
  const Chord chord = chordOf(shear, centre, ends, radius);
  const bool startsOutside = outside(centre, radius), endsOutside = outside(end, radius);
  const bool passes = startsOutside && chord.middle > 0.0f && chord.middle < last;
  return chord.hit && (startsOutside != endsOutside || passes) && ends.x <= last && ends.y >= 0.0f;
}

// hi + lo: a sum with an error of about 2^-46 of its largest term.
struct LongFloat {
  float hi, lo;
};
LAVER_FN LongFloat longFloat(float hi, float lo) {
  LongFloat x;
  x.hi = hi;
  x.lo = lo;
  return x;
}

// Knuth's two-sum.
LAVER_FN LongFloat plus(LongFloat x, float y) {
  LAVER_PRECISE float sum = x.hi + y;
  LAVER_PRECISE float part = sum - x.hi;
  LAVER_PRECISE float lo = x.lo + ((x.hi - (sum - part)) + (y - part));
  return longFloat(sum, lo);
}

// x + a * b. Products of halves are exact, so contraction does not change a bit
// (accurateDifference).
LAVER_FN LongFloat plusProduct(LongFloat x, float a, float b) {
  const float ah = upperHalf(a), bh = upperHalf(b);
  LAVER_PRECISE float al = a - ah;
  LAVER_PRECISE float bl = b - bh;
  LongFloat sum = plus(plus(plus(x, ah * bh), ah * bl), al * bh);
  LAVER_PRECISE float lo = sum.lo + al * bl;
  return plus(longFloat(sum.hi, 0.0f), lo);
}

// (origin - centre + t * d) * unit on one axis.
LAVER_FN LongFloat awayOnAxis(float origin, float centre, float t, float d, float unit) {
  const LongFloat away = plusProduct(plus(longFloat(origin, 0.0f), -centre), t, d);
  return longFloat(away.hi * unit, away.lo * unit);
}

// The hit point on a sphere, recomputed once. `weights` are meaningless.
LAVER_FN Point spherePointAt(vec3 origin, vec3 direction, float tmin, vec3 centre, float radius) {
  const Shear shear = shearOf(direction);
  const float scale = abs(alongAxis(direction, shear.axis));
  const vec2 ends = endsOf(permute(shear, centre).z, radius, permute(shear, origin).z);
  const Chord chord = chordOf(shear, permute(shear, centre - origin), ends, radius);
  LAVER_PRECISE float t = depthOn(chord, tmin * scale) / scale;

  // Two steps of Newton's method on |p|^2 - radius^2, whose large parts cancel exactly. p is scaled
  // to unit size, so that tiny spheres do not underflow.
  const float unit = scaleToUnit(radius);
  LongFloat x = awayOnAxis(origin.x, centre.x, t, direction.x, unit);
  LongFloat y = awayOnAxis(origin.y, centre.y, t, direction.y, unit);
  LongFloat z = awayOnAxis(origin.z, centre.z, t, direction.z, unit);
  const vec3 scaledDirection = direction * unit;
  // Where the line grazes the sphere a step may overshoot: it is limited to a quarter of the chord.
  const float limit = 0.25f * (chord.far - chord.near) / scale;
  float back = 0.0f;
  for (uint i = 0u; i < 2u; ++i) {
    LongFloat sum = plusProduct(longFloat(0.0f, 0.0f), -radius * unit, radius * unit);
    sum = plusProduct(plusProduct(plusProduct(sum, x.hi, x.hi), y.hi, y.hi), z.hi, z.hi);
    const vec3 p = vec3(x.hi, y.hi, z.hi);
    LAVER_PRECISE float excess = sum.hi + (sum.lo + 2.0f * dotProduct(p, vec3(x.lo, y.lo, z.lo)));
    const float speed = 2.0f * dotProduct(p, scaledDirection);
    const float moved = speed != 0.0f ? clamped(-limit, excess / speed, limit) : 0.0f;
    x = plus(x, -scaledDirection.x * moved);
    y = plus(y, -scaledDirection.y * moved);
    z = plus(z, -scaledDirection.z * moved);
    back += moved;
  }

  Point point;
  LAVER_PRECISE float nearer = t - back;
  point.t = nearer;
  LAVER_PRECISE vec3 away = vec3(x.hi, y.hi, z.hi) + vec3(x.lo, y.lo, z.lo);
  point.geometric = unitOr(away, unitOr(-direction, vec3(0.0f, 0.0f, 1.0f)));
  LAVER_PRECISE vec3 position = centre + point.geometric * radius;
  point.position = position;
  point.weights = vec3(1.0f, 0.0f, 0.0f);
  // With e = 2^-24: the normal's length errs by 8 e and the sum by e |position| on each axis; from
  // here the line's distance from the centre errs by 8 e radius and the outline by 5 e radius
  // (chordOf()): 21 e radius and e |n| . |position| in all.
  const vec3 tilt = vec3(abs(point.geometric.x), abs(point.geometric.y), abs(point.geometric.z));
  const vec3 largest = vec3(abs(position.x), abs(position.y), abs(position.z));
  point.offset = 5.9604645e-8f * (32.0f * radius + 4.0f * dotProduct(tilt, largest));
  return point;
}

LAVER_SHARED_END

#endif
