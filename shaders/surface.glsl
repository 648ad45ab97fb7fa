// The point that a ray has met, recomputed once from the winner's corners.
#ifndef LAVER_SURFACE
#define LAVER_SURFACE
#include "resources.glsl"
#include "shared/triangle.h"

struct Surface {
  vec3 position;   // by barycentrics: on the triangle to rounding, however far the camera
  vec3 geometric;  // unit normal by the winding
  vec3 normal;     // unit shading normal
  float t;         // along the ray, by the plane
  float offset;    // how far along the geometric normal a shadow ray ends beside the surface
  uint material;
};

// v / |v|, free of overflow and underflow; `otherwise` where v is zero.
vec3 unitOr(vec3 v, vec3 otherwise) {
  const float m = max(abs(v.x), max(abs(v.y), abs(v.z)));
  const vec3 s = v / (m > 0.0 ? m : 1.0);
  return m > 0.0 ? s / sqrt(dotProduct(s, s)) : otherwise;
}

Surface surfaceAt(vec3 origin, vec3 direction, uint slot) {
  const int texel = int(slot * 3u);
  const vec3 a = texelVec3(texelFetch(triangleTexels, texel));
  const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
  const uvec4 last = texelFetch(triangleTexels, texel + 2);
  const vec3 c = texelVec3(last);
  const Shear shear = shearOf(direction);
  const vec3 pa = permute(shear, a - origin);
  const vec3 pb = permute(shear, b - origin);
  const vec3 pc = permute(shear, c - origin);
  const Edges e = edgesOf(shear, pa, pb, pc);
  precise float wa = e.a / e.sum;
  precise float wb = e.b / e.sum;
  precise float wc = e.c / e.sum;

  Surface s;
  precise vec3 position = a * wa + b * wb + c * wc;
  s.position = position;
  const vec3 n = crossProduct(b - a, c - a) * (last.w != 0u ? -1.0 : 1.0);
  s.geometric = unitOr(n, unitOr(-direction, vec3(0.0, 0.0, 1.0)));

  // Plane distance; the edge functions' where the plane is seen edge-on, and always between the
  // corners.
  const float across = dotProduct(n, direction);
  const float scale = abs(alongAxis(direction, shear.axis));
  const float nearest = min(pa.z, min(pb.z, pc.z)), farthest = max(pa.z, max(pb.z, pc.z));
  const float depth = across != 0.0 ? dotProduct(n, a - origin) / across * scale
                                    : depthOf(e, pa.z, pb.z, pc.z);
  s.t = max(nearest, min(depth, farthest)) / scale;

  // 8 * 2^-24 * (|n| . max |corner|): the rounding of `position` is below 3 * 2^-24 * max |corner|
  // on each axis; 8 leaves room for the dot products of the plane-side test.
  const vec3 largest = max(abs(a), max(abs(b), abs(c)));
  s.offset = 4.7683716e-7 * dotProduct(abs(s.geometric), largest);

  s.normal = s.geometric;
  s.material = 0u;
  if (HAS_NORMALS || HAS_ALBEDOS) {
    const uvec4 attributes = texelFetch(attributeTexels, int(slot));
    s.material = attributes.w;
    if (HAS_NORMALS) {
      const bool smoothed = attributes.x != NO_NORMAL;
      const ivec3 index = ivec3(smoothed ? attributes.xyz : uvec3(0u));
      const vec3 na = texelVec3(texelFetch(normalTexels, index.x));
      const vec3 nb = texelVec3(texelFetch(normalTexels, index.y));
      const vec3 nc = texelVec3(texelFetch(normalTexels, index.z));
      precise vec3 m = na * wa + nb * wb + nc * wc;
      // Below 2^-22 of unit normals' length the sum is rounding alone.
      const bool usable = smoothed && dotProduct(m, m) > 5.7e-14;
      s.normal = usable ? unitOr(m, s.geometric) : s.geometric;
    }
  }
  return s;
}

vec3 albedoOf(Surface s) {
  if (!HAS_ALBEDOS) return params.albedo.rgb;
  return texelVec3(texelFetch(materialTexels, int(s.material)));
}

#endif
