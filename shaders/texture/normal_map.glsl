// Normal maps: a texture's colour c is the normal 2c - 1 in the frame whose z is the shading normal n, whose x lies
// along dp/du, on a sphere along the meridian from +z, and whose y is n x x.
#include "texture/textured.glsl"

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

// A direction across n where there is none along u, as in Nori's frames.
vec3 acrossNormal(vec3 n) {
  const vec3 y = abs(n.x) > abs(n.y) ? vec3(n.z, 0.0, -n.x) : vec3(0.0, n.z, -n.y);
  return crossProduct(y, n);
}

vec3 mappedNormal(Surface s, uint number) {
  const vec3 c = 2.0 * textureAt(number, s.id, s.weights) - 1.0;
  const vec3 along = alongU(s, 3u * (s.id + texelFetch(textureTexels, int(number * 4u) + 1).w));
  const vec3 n = s.normal;
  const vec3 x = unitOr(along - n * dotProduct(n, along), unitOr(acrossNormal(n), n));
  return unitOr(x * c.x + crossProduct(n, x) * c.y + n * c.z, n);
}
