// Ray/sphere test in the triangle test's terms (triangle.h): sheared, by depth along the ray's
// dominant axis, so that one walk, one set of boxes and one rule for ties serve both.
#ifndef LAVER_SHARED_SPHERE_H
#define LAVER_SHARED_SPHERE_H
#include "shared/box.h"
#include "shared/point.h"

LAVER_SHARED_BEGIN

// Depths at which a line meets a sphere, and of its point nearest the centre.
struct Chord {
  float near, middle, far;
  bool met;
};

// A power of two that takes a radius of 2^-100 to 1 into [1, 2).
LAVER_FN float scaleToUnit(float radius) {
  return uintBitsToFloat((254u << 23) - (floatBitsToUint(radius) & 0x7f800000u));
}

LAVER_FN float held(float least, float x, float most) { return greater(least, lesser(x, most)); }

// Depths of a sphere's ends from the permuted depths of its centre and of the origin, rounded in
// the order in which boxes are: their own never lie farther in.
LAVER_FN vec2 endsOf(float centre, float radius, float origin) {
  LAVER_PRECISE vec2 ends = vec2(centre - radius, centre + radius);
  LAVER_PRECISE vec2 result = ends - origin;
  return result;
}

// `centre` is permuted and relative to the origin.
//
// With S the vector from the line to the centre at the centre's own depth and D = (u, v, 1), the
// line passes the centre at |S x D| / |D|, a sum of squares that cancels nothing, so that far and
// small spheres keep their outline (b^2 - ac loses it; Haines, Guenther and Akenine-Moeller,
// "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019). Roundings: S by 8
// e A as in padOf(); squares, sum and |D|^2 by 5 e radius, which the box's growth holds
// (BALL_GROWTH).
LAVER_FN Chord chordOf(Shear shear, vec3 centre, vec2 ends, float radius) {
  const float scale = scaleToUnit(radius);
  LAVER_PRECISE float sx = centre.x - shear.u * centre.z;
  LAVER_PRECISE float sy = centre.y - shear.v * centre.z;
  LAVER_PRECISE float along = 1.0f + (shear.u * shear.u + shear.v * shear.v);
  const float x = held(-1e9f, sx * scale, 1e9f), y = held(-1e9f, sy * scale, 1e9f);
  LAVER_PRECISE float cross = x * shear.v - y * shear.u;
  LAVER_PRECISE float apart = x * x + y * y + cross * cross;
  const float unit = radius * scale;
  LAVER_PRECISE float left = unit * unit * along - apart;
  LAVER_PRECISE float halfChord = sqrt(greater(left, 0.0f)) / along / scale;
  LAVER_PRECISE float middle = centre.z + (shear.u * sx + shear.v * sy) / along;
  Chord chord;
  chord.middle = middle;
  // Held between the ends, like depthOf() between corners: pruning by depth changes no winner.
  chord.near = held(ends.x, middle - halfChord, ends.y);
  chord.far = held(ends.x, middle + halfChord, ends.y);
  chord.met = left >= 0.0f;
  return chord;
}

// What a sphere's box adds to its radius, relative: the 5 e of chordOf(), rounded up.
LAVER_CONST float BALL_GROWTH = 1.0f + 8.0f * 5.9604645e-8f;

// The hit of a ray that begins at depth `first`: where it enters, or leaves if it begins inside.
LAVER_FN float depthOn(Chord chord, float first) {
  return chord.near >= first ? chord.near : chord.far;
}

// Is a point, relative to the centre, outside?
LAVER_FN bool outside(vec3 point, float radius) {
  const float scale = scaleToUnit(radius);
  const vec3 p = vec3(held(-1e9f, point.x * scale, 1e9f), held(-1e9f, point.y * scale, 1e9f),
                      held(-1e9f, point.z * scale, 1e9f));
  LAVER_PRECISE float unit = radius * scale * (radius * scale);
  return dotProduct(p, p) > unit;
}

// Does a sphere block the view between a point and an end of the line? `centre` is relative to the
// point, `end` to the centre, both permuted. One of the two inside and one outside: yes, both
// inside: no, it is hollow; both outside: if the line's nearest point lies between them. No
// distance of a hit is compared, as with triangles (blocks()).
LAVER_FN bool ballBlocks(Shear shear, float last, vec3 centre, vec3 end, vec2 ends, float radius) {
  const Chord chord = chordOf(shear, centre, ends, radius);
  const bool begins = outside(centre, radius), leaves = outside(end, radius);
  const bool passes = begins && chord.middle > 0.0f && chord.middle < last;
  return chord.met && (begins != leaves || passes) && ends.x <= last && ends.y >= 0.0f;
}

// hi + lo, a sum of terms to some 2^-46 of the largest.
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

// x + a * b: products of halves are exact, so that contraction changes no bit (accurateDifference).
LAVER_FN LongFloat plusProduct(LongFloat x, float a, float b) {
  const float ah = upperHalf(a), bh = upperHalf(b);
  LAVER_PRECISE float al = a - ah;
  LAVER_PRECISE float bl = b - bh;
  LongFloat sum = plus(plus(plus(x, ah * bh), ah * bl), al * bh);
  LAVER_PRECISE float lo = sum.lo + al * bl;
  return plus(longFloat(sum.hi, 0.0f), lo);
}

LAVER_FN LongFloat awayOnAxis(float origin, float centre, float t, float d, float unit) {
  const LongFloat away = plusProduct(plus(longFloat(origin, 0.0f), -centre), t, d);
  return longFloat(away.hi * unit, away.lo * unit);
}

// The hit on a sphere, recomputed once. `weights` mean nothing.
LAVER_FN Point ballPointAt(vec3 origin, vec3 direction, float tmin, vec3 centre, float radius) {
  const Shear shear = shearOf(direction);
  const float scale = abs(alongAxis(direction, shear.axis));
  const vec2 ends = endsOf(permute(shear, centre).z, radius, permute(shear, origin).z);
  const Chord chord = chordOf(shear, permute(shear, centre - origin), ends, radius);
  LAVER_PRECISE float t = depthOn(chord, tmin * scale) / scale;

  // Two steps of Newton's method on |p|^2 - radius^2, whose large parts cancel exactly; p is of
  // unit size, so that tiny spheres do not underflow.
  const float unit = scaleToUnit(radius);
  LongFloat x = awayOnAxis(origin.x, centre.x, t, direction.x, unit);
  LongFloat y = awayOnAxis(origin.y, centre.y, t, direction.y, unit);
  LongFloat z = awayOnAxis(origin.z, centre.z, t, direction.z, unit);
  const vec3 way = direction * unit;
  // Where the line grazes the sphere a step may leave it: no farther than a quarter of the chord.
  const float most = 0.25f * (chord.far - chord.near) / scale;
  float back = 0.0f;
  for (uint i = 0u; i < 2u; ++i) {
    LongFloat sum = plusProduct(longFloat(0.0f, 0.0f), -radius * unit, radius * unit);
    sum = plusProduct(plusProduct(plusProduct(sum, x.hi, x.hi), y.hi, y.hi), z.hi, z.hi);
    const vec3 p = vec3(x.hi, y.hi, z.hi);
    LAVER_PRECISE float excess = sum.hi + (sum.lo + 2.0f * dotProduct(p, vec3(x.lo, y.lo, z.lo)));
    const float speed = 2.0f * dotProduct(p, way);
    const float moved = speed != 0.0f ? held(-most, excess / speed, most) : 0.0f;
    x = plus(x, -way.x * moved);
    y = plus(y, -way.y * moved);
    z = plus(z, -way.z * moved);
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
