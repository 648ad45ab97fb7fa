// The hit point on the primitive of a slot, for a ray that begins at tmin, and the number of the primitive.
#include "resources.glsl"
#include "shared/cap.h"
#include "trace/sphere_hit.glsl"

Point hitPointAt(vec3 origin, vec3 direction, float tmin, uint slot, out uint id) {
  const int texel = int(slot * 3u);
  const uvec4 first = texelFetch(triangleTexels, texel);
  const vec3 a = texelVec3(first);
  const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
  const uvec4 last = texelFetch(triangleTexels, texel + 2);
  id = first.w;
  Point p = pointAt(origin, direction, a, b, texelVec3(last), last.w != 0u);
  if (HAS_SPHERES) {
    if (last.w == IS_SPHERE) p = sphereHitAt(origin, direction, tmin, a, b.x);
  }
  if (HAS_CAPS) {
    if (last.w == IS_CAP) {
      p = capPointAt(origin, direction, tmin, capOf(a, b, texelVec3(last)));
      p.weights = vec3(0.0, uvOnSphere(p.geometric));
    }
  }
  return p;
}
