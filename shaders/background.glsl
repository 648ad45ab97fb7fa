// What a ray that meets nothing sees.
#ifndef LAVER_BACKGROUND
#define LAVER_BACKGROUND
#include "picture.glsl"
#include "shared/triangle.h"
#include "turn.glsl"

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
