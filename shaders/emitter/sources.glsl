// Light sampling: all light sources of a scene as one list, of which a surface draws one with a probability
// by its power; then a point of it. emissionTexels: what each mesh emits.
#include "trace/surface.glsl"
#include "shared/direction.h"

// Density of light sampling per area of a mesh that emits.
float emissionDensity(uint mesh) { return uintBitsToFloat(texelFetch(emissionTexels, int(mesh) * 2).w); }

vec3 emittedTowards(Surface s, vec3 direction) {
  if (!HAS_EMISSION || dotProduct(s.normal, direction) <= 0.0) return vec3(0.0);
  return radianceOf(s.material, s.id, s.weights);
}

// Density per solid angle with which light sampling at `origin` draws the point of a mesh that a ray from
// there has met. Where triangles' probabilities were rounded it is not exact: a weight among strategies
// only.
float sourceDensity(Surface s, vec3 origin, vec3 direction) {
  const vec3 away = s.position - origin;
  const float perArea = emissionDensity(s.material);
  const float cosine = abs(dotProduct(s.geometric, unitOr(direction, s.geometric)));
  return cosine > 0.0 ? perArea * dotProduct(away, away) / cosine : 0.0;
}

// What comes from one source to a surface, if nothing lies on the segment from its offset origin.
struct SourceSample {
  vec3 direction;  // unit
  vec3 end;        // of the segment
  vec3 radiance;   // over the density per solid angle; of a point light, over the squared distance
  float density;   // per solid angle, 0: a point light
};

// The first source whose `upper` exceeds the number.
Source drawSource(float number) {
  uint low = 0u, count = params.sources;
  DO(count > 0u) {
    const uint middle = count / 2u;
    const bool above = uintBitsToFloat(texelFetch(sourceTexels, int(low + middle)).z) <= number;
    low = above ? low + middle + 1u : low;
    count = above ? count - middle - 1u : middle;
  } WHILE(count > 0u);
  const uvec4 texel = texelFetch(sourceTexels, int(low < params.sources ? low : params.sources - 1u));
  return Source(texel.x, texel.y, uintBitsToFloat(texel.z), uintBitsToFloat(texel.w));
}

struct SourcePoint {
  vec3 position, geometric, normal;
  float offset, area;
  uint material, id;
  vec3 weights;  // of the corners
};

// A point of a triangle or a sphere, uniform by area. Corners are in the order of storage.
SourcePoint pointOn(uint slot, vec2 numbers) {
  const int texel = int(slot * 3u);
  const uvec4 first = texelFetch(triangleTexels, texel);
  const vec3 a = texelVec3(first);
  const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
  const uvec4 last = texelFetch(triangleTexels, texel + 2);
  const vec3 c = texelVec3(last);
  SourcePoint p;
  p.material = 0u;
  p.id = first.w;
  uvec4 attributes = uvec4(0u);
  if (HAS_NORMALS || HAS_MATERIALS) {
    attributes = texelFetch(attributeTexels, int(slot));
    p.material = attributes.x;
  }
  if (HAS_SPHERES) {
    if (last.w == IS_SPHERE) {
      const float radius = b.x;
      p.normal = p.geometric = sphereDirection(numbers);
      p.weights = vec3(0.0, uvOnSphere(p.normal));
      p.position = a + p.normal * radius;
      p.area = 12.5663706 * radius * radius;
      // As of a hit (shared/sphere.h), without the terms of a ray.
      p.offset = 5.9604645e-8 * (16.0 * radius + 4.0 * dotProduct(abs(p.normal), abs(p.position)));
      return p;
    }
  }
  if (HAS_CAPS) {
    if (last.w == IS_CAP) {
      p.normal = p.geometric = sphereDirection(numbers);
      p.weights = vec3(0.0, uvOnSphere(p.normal));
      p.position = a + (p.normal - b) / c.x;
      p.area = 12.5663706 / (c.x * c.x);
      p.offset = 5.9604645e-8 * (16.0 / c.x + 4.0 * dotProduct(abs(p.normal), abs(p.position)));
      return p;
    }
  }
  const float root = sqrt(numbers.x);
  const vec3 weights = vec3(1.0 - root, root - numbers.y * root, numbers.y * root);
  p.weights = weights;
  const vec3 n = accurateCross(b - a, c - a) * (last.w != 0u ? -1.0 : 1.0);
  p.position = a + ((b - a) * weights.y + (c - a) * weights.z);
  p.geometric = unitOr(n, vec3(0.0, 0.0, 1.0));
  p.area = 0.5 * sqrt(dotProduct(n, n));
  p.normal = p.geometric;
  // As of a hit (shared/point.h).
  const vec3 largest =
      vec3(largestOf(a.x, b.x, c.x), largestOf(a.y, b.y, c.y), largestOf(a.z, b.z, c.z));
  p.offset = 4.7683716e-7 * dotProduct(abs(p.geometric), largest);
  if (HAS_NORMALS) {
    if (attributes.y != NO_NORMAL) {
      const ivec3 index = ivec3(attributes.yzw);
      Point hit;
      hit.weights = weights;
      hit.geometric = p.geometric;
      p.normal = shadingNormal(hit, texelVec3(texelFetch(normalTexels, index.x)),
                               texelVec3(texelFetch(normalTexels, index.y)),
                               texelVec3(texelFetch(normalTexels, index.z)));
    }
  }
  return p;
}

SourceSample samplePrimitive(Surface s, uint slot, vec2 numbers) {
  const SourcePoint p = pointOn(slot, numbers);
  SourceSample arriving;
  const vec3 away = p.position - s.position;
  const float squared = dotProduct(away, away);
  arriving.direction = unitOr(away, s.normal);
  const float cosine = abs(dotProduct(p.geometric, arriving.direction));
  const bool seen = dotProduct(p.normal, arriving.direction) < 0.0 && cosine > 0.0 && squared > 0.0;
  // Both ends lie on their own side of the surfaces that they belong to.
  const float side = dotProduct(p.geometric, arriving.direction) < 0.0 ? p.offset : -p.offset;
  arriving.end = p.position + p.geometric * side;
  arriving.density = seen ? emissionDensity(p.material) * squared / cosine : 0.0;
  arriving.radiance =
      seen ? radianceOf(p.material, p.id, p.weights) * (cosine / squared * p.area) : vec3(0.0);
  return arriving;
}

// One sample of all light that arrives at a surface.
SourceSample sampleSources(Surface s, float number, vec2 numbers) {
  SourceSample arriving;
  arriving.direction = s.normal;
  arriving.end = s.position;
  arriving.radiance = vec3(0.0);
  arriving.density = 0.0;
  // All sources may be black.
  if (params.sources == 0u) return arriving;
  const Source source = drawSource(number);
  if (HAS_EMISSION) {
    if (source.kind == SOURCE_PRIMITIVE) {
      arriving = samplePrimitive(s, source.index, numbers);
      arriving.radiance /= source.probability;
    }
  }
  if (HAS_LIGHTS) {
    if (source.kind == SOURCE_POINT) {
      const PointLight light = seenFrom(pointLightAt(source.index), source.index, s.position);
      const vec3 away = light.position - s.position;
      const float squared = dotProduct(away, away);
      arriving.direction = unitOr(away, s.normal);
      arriving.end = light.position;
      arriving.radiance = squared > ON_SURFACE ? light.radiance / squared : vec3(0.0);
      arriving.radiance /= source.probability;
    }
  }
  if (HAS_BACKGROUND) {
    if (source.kind == SOURCE_BACKGROUND) {
      arriving.direction = sampleBackground(source, numbers, arriving.density, arriving.radiance);
      arriving.end = s.position + arriving.direction * params.sceneReach;
      arriving.radiance =
          arriving.density > 0.0 ? arriving.radiance / arriving.density : vec3(0.0);
    }
  }
  return arriving;
}
