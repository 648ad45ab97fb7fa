// Directions on the hemisphere of a unit normal, from two uniform random numbers. They are
// continuous in the normal, which no tangent frame is everywhere: a small change of the normal is a
// small change of the direction.
#ifndef LAVER_SHARED_DIRECTION_H
#define LAVER_SHARED_DIRECTION_H
#include "shared/point.h"

LAVER_SHARED_BEGIN

// Cosine and sine of 2 pi x for x in [0, 1], within 2e-7; a driver's own may be off by 2^-11. The
// remainder of x after removing quarter turns is exact; the Taylor polynomials are off by 3e-8
// there.
LAVER_FN vec2 cosSinOfTurn(float x) {
  const uint quarters = uint(4.0f * x + 0.5f);
  LAVER_PRECISE float angle = (4.0f * x - float(quarters)) * 1.57079633f;
  LAVER_PRECISE float a2 = angle * angle;
  LAVER_PRECISE float s =
      angle *
      (1.0f + a2 * (-1.0f / 6.0f + a2 * (1.0f / 120.0f + a2 * (-1.0f / 5040.0f + a2 / 362880.0f))));
  LAVER_PRECISE float c =
      1.0f + a2 * (-0.5f + a2 * (1.0f / 24.0f + a2 * (-1.0f / 720.0f + a2 * (1.0f / 40320.0f))));
  const bool swaps = (quarters & 1u) != 0u;
  const float right = chosen(swaps, -s, c), up = chosen(swaps, c, s);
  const bool turns = (quarters & 2u) != 0u;
  return vec2(chosen(turns, -right, right), chosen(turns, -up, up));
}

// Uniform on the sphere: its z is uniform in [-1, 1] (Archimedes).
LAVER_FN vec3 sphereDirection(vec2 numbers) {
  LAVER_PRECISE float radius = 2.0f * sqrt(numbers.x * (1.0f - numbers.x));
  const vec2 cosSin = cosSinOfTurn(numbers.y);
  LAVER_PRECISE vec3 d = vec3(cosSin.x * radius, cosSin.y * radius, 1.0f - 2.0f * numbers.x);
  return d;
}

// Uniform on the hemisphere: directions below the surface are mirrored.
LAVER_FN vec3 uniformDirection(vec3 normal, vec2 numbers) {
  const vec3 d = sphereDirection(numbers);
  const float below = 2.0f * lesser(dotProduct(normal, d), 0.0f);
  LAVER_PRECISE vec3 mirrored = d - normal * below;
  return mirrored;
}

// With density cosine / pi: normal + a uniform point of the unit sphere, normalised.
LAVER_FN vec3 cosineDirection(vec3 normal, vec2 numbers) {
  return unitOr(normal + sphereDirection(numbers), normal);
}

LAVER_SHARED_END

#endif
