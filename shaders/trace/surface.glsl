// The surface at a hit: the point on the triangle or sphere, its shading normal and its material.
#include "resources.glsl"
#include "shared/point.h"
#include "trace/hit_point.glsl"

struct Surface {
  vec3 position;   // shared/point.h
  vec3 geometric;
  vec3 normal;     // unit shading normal
  float t;
  float offset;
  uint material;
  vec3 weights;    // of the corners
  uint id, slot;   // of the primitive
};

// The surface at the hit of a ray, from `tmin` on, with the primitive in `slot`.
Surface surfaceFrom(vec3 origin, vec3 direction, float tmin, uint slot) {
  Surface s;
  s.slot = slot;
  const Point p = hitPointAt(origin, direction, tmin, slot, s.id);
  s.position = p.position;
  s.geometric = p.geometric;
  s.t = p.t;
  s.offset = p.offset;
  s.normal = p.geometric;
  s.material = 0u;
  s.weights = p.weights;
  if (HAS_NORMALS || HAS_MATERIALS) {
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

// The same of a camera ray.
Surface surfaceAt(vec3 origin, vec3 direction, uint slot) {
  return surfaceFrom(origin, direction, params.tmin, slot);
}

// The origin of a ray that leaves the surface along `direction`: offset to that side by the rounding error of
// the hit point.
vec3 offsetOrigin(Surface s, vec3 direction) {
  const float side = chosen(dotProduct(s.geometric, direction) < 0.0, -s.offset, s.offset);
  return s.position + s.geometric * side;
}

// The length of t * direction in scene units.
float sceneLength(float t, vec3 direction) {
  precise float length = t * sqrt(dotProduct(direction, direction)) * params.sceneUnits;
  return length;
}

// The same from the camera, for a camera ray.
float cameraDistance(float t, vec3 direction) {
  precise float fromCamera = FAR_CAMERA ? t + params.startT : t;
  return sceneLength(fromCamera, direction);
}
