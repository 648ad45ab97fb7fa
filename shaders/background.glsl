// What a ray that meets nothing sees.
#ifndef LAVER_BACKGROUND
#define LAVER_BACKGROUND
#include "picture.glsl"
#include "shared/triangle.h"

// The angle of (x, y) from +x towards +y, as a share of a whole turn, in [-1/2, 1/2]; 0 at (0, 0).
// Within 4 ulp of 1/2: drivers' own may be off by 4096 ulp. The angle to the nearest multiple of an
// eighth turn has a tangent of tan(pi/8) at most, on which the polynomial's minimax error is 2e-8.
float turnOf(float y, float x) {
  const bool steep = abs(y) > abs(x);
  const float large = steep ? abs(y) : abs(x);
  const float small = steep ? abs(x) : abs(y);
  const bool diagonal = small > 0.41421357 * large;
  const float opposite = diagonal ? small - large : small;
  const float adjacent = diagonal ? small + large : large;
  const float q = adjacent > 0.0 ? opposite / adjacent : 0.0;
  const float z = q * q;
  const float p =
      ((0.080603085 * z - 0.1387985) * z + 0.19977926) * z - 0.33332956;
  const float eighths = (q + q * z * p) * 0.15915494 + (diagonal ? 0.125 : 0.0);
  const float quarter = steep ? 0.25 - eighths : eighths;
  const float halves = x < 0.0 ? 0.5 - quarter : quarter;
  return y < 0.0 ? -halves : halves;
}

vec3 backgroundAt(vec3 direction) {
  const vec4 rx = params.background[0], ry = params.background[1], rz = params.background[2];
  vec3 radiance = vec3(rx.w, ry.w, rz.w);
  if (BACKGROUND == BACKGROUND_IMAGE && params.backgroundPicture.width != 0u) {
    const vec3 d = vec3(dotProduct(rx.xyz, direction), dotProduct(ry.xyz, direction),
                        dotProduct(rz.xyz, direction));
    const float s = unitPart(turnOf(d.x, -d.z));
    const float t = 2.0 * turnOf(sqrt(d.x * d.x + d.z * d.z), d.y);
    radiance *= pictureAt(params.backgroundPicture, s, t, false);
  }
  return radiance;
}

#endif
