// The tangent of a surface along u, on a sphere along the meridian from +z.
#include "trace/surface.glsl"

// Any length; 0 where the texture coordinates have no direction. Two products of float differences that agree to
// 2^-20 are equal within the rounding of texture coordinates.
vec3 alongU(Surface s, uint firstUv) {
  const int texel = int(s.slot * 3u);
  const uvec4 last = texelFetch(triangleTexels, texel + 2);
  if (HAS_SPHERES || HAS_CAPS) {
    const vec3 n = s.geometric;
    if (last.w == IS_SPHERE || last.w == IS_CAP)
      return vec3(n.x * n.z, n.y * n.z, -(n.x * n.x + n.y * n.y));
  }
  const vec3 a = texelVec3(texelFetch(triangleTexels, texel));
  const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
  const vec3 c = texelVec3(last);
  const vec2 from = uintBitsToFloat(texelFetch(uvTexels, int(firstUv)).xy);
  const vec2 d1 = uintBitsToFloat(texelFetch(uvTexels, int(firstUv) + 1).xy) - from;
  const vec2 d2 = uintBitsToFloat(texelFetch(uvTexels, int(firstUv) + 2).xy) - from;
  precise const float left = d1.x * d2.y, right = d1.y * d2.x;
  const float area = left - right;
  if (abs(area) <= 9.5367432e-7 * (abs(left) + abs(right))) return vec3(0.0);
  return ((b - a) * d2.y - (c - a) * d1.y) * (area < 0.0 ? -1.0 : 1.0);
}
