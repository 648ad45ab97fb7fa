// What a camera ray has met: the point on the triangle or sphere, its shading normal, its material.
#ifndef LAVER_SURFACE
#define LAVER_SURFACE
#include "resources.glsl"
#include "shared/point.h"
#ifdef LAVER_SPHERES
#include "ball.glsl"
#endif
#ifdef LAVER_TEXTURES
#include "texture.glsl"
#endif

struct Surface {
  vec3 position;   // shared/point.h
  vec3 geometric;
  vec3 normal;     // unit shading normal
  float t;
  float offset;
  uint material;
  vec3 weights;    // of the corners
  uint id;
};

Surface surfaceAt(vec3 origin, vec3 direction, uint slot) {
  const int texel = int(slot * 3u);
  const uvec4 first = texelFetch(triangleTexels, texel);
  const vec3 a = texelVec3(first);
  const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
  const uvec4 last = texelFetch(triangleTexels, texel + 2);
  Point p = pointAt(origin, direction, a, b, texelVec3(last), last.w != 0u);
#ifdef LAVER_SPHERES
  if (last.w == IS_SPHERE) p = ballAt(origin, direction, params.clip.x, a, b.x);
#endif

  Surface s;
  s.position = p.position;
  s.geometric = p.geometric;
  s.t = p.t;
  s.offset = p.offset;
  s.normal = p.geometric;
  s.material = 0u;
  s.weights = p.weights;
  s.id = first.w;
  if (HAS_NORMALS || HAS_ALBEDOS) {
    const uvec4 attributes = texelFetch(attributeTexels, int(slot));
    s.material = attributes.x;
    if (HAS_NORMALS) {
      const bool smoothed = attributes.y != NO_NORMAL;
      const ivec3 index = ivec3(attributes.yzw);
      const vec3 na = texelVec3(texelFetch(normalTexels, index.x));
      const vec3 nb = texelVec3(texelFetch(normalTexels, index.y));
      const vec3 nc = texelVec3(texelFetch(normalTexels, index.z));
      s.normal = smoothed ? shadingNormal(p, na, nb, nc) : p.geometric;
    }
  }
  return s;
}

// Where a ray that leaves along `way` begins: beside the surface by the rounding of that very point.
vec3 beside(Surface s, vec3 way) {
  const float side = dotProduct(s.geometric, way) < 0.0 ? -s.offset : s.offset;
  return s.position + s.geometric * side;
}

vec3 albedoOf(Surface s) {
#ifdef LAVER_TEXTURES
  if (TEXTURES != 0u) return textureAt(s.material, s.id, s.weights);
#endif
  if (!HAS_ALBEDOS) return params.albedo.rgb;
  return texelVec3(texelFetch(materialTexels, int(s.material)));
}

#endif
