// Traces rays from memory by the production traversals and stores the hits. The preceding text selects the
// query. A workgroup takes 64 rays or 64 points.
#include "trace/surface.glsl"

layout(local_size_x = 64 / R) in;
// Ray: origin, tmin; direction, tmax. Point: xyz, unused.
layout(binding = BINDINGS) uniform utextureBuffer inputTexels;
layout(binding = BINDINGS + 1) writeonly buffer OutputBlock { Stored outputOf[]; };
// Pass is used as: region.x the count; core.xyz the light, as bits of floats.

uint groupNumber() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint numberOf(uint r) { return groupNumber() * 64u + gl_LocalInvocationIndex * R + r; }

void seePoints() {
  vec3 points[R];
  bool given[R], clear[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const bool inside = numberOf(r) < pass.region.x;
    const uvec4 point = texelFetch(inputTexels, int(inside ? numberOf(r) : 0u));
    points[r] = texelVec3(point);
    given[r] = inside && (point.x & 0x7fffffffu) <= 0x7f800000u;
  }
  unoccludedToOne(uintBitsToFloat(pass.core.xyz), points, given, clear);
  FOR_RAYS (uint r = 0u; r < R; ++r)
    if (numberOf(r) < pass.region.x)
      outputOf[numberOf(r)] = stored(vec4(clear[r] ? 1.0 : 0.0, 0.0, 0.0, 0.0));
}

vec4 hitAt(vec3 origin, vec3 direction, float tmin, uint slot) {
  const int texel = int(slot * 3u);
  const uvec4 first = texelFetch(triangleTexels, texel);
  const vec3 a = texelVec3(first);
  const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
  const uvec4 last = texelFetch(triangleTexels, texel + 2);
  Point p = pointAt(origin, direction, a, b, texelVec3(last), false);
  if (HAS_SPHERES) {
    if (last.w == IS_SPHERE) p = spherePointAt(origin, direction, tmin, a, b.x);
  }
  return vec4(p.t, p.weights.yz, uintBitsToFloat(first.w));
}

Rays readRays() {
  Rays rays;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    rays.isActive[r] = numberOf(r) < pass.region.x;
    const int texel = int(rays.isActive[r] ? numberOf(r) : 0u) * 2;
    const uvec4 start = texelFetch(inputTexels, texel), ahead = texelFetch(inputTexels, texel + 1);
    rays.origin[r] = texelVec3(start);
    rays.tmin[r] = uintBitsToFloat(start.w);
    rays.direction[r] = texelVec3(ahead);
    rays.tmax[r] = uintBitsToFloat(ahead.w);
  }
  return rays;
}

void writeHits(Rays rays, Hits hits) {
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (!rays.isActive[r]) continue;
    vec4 result = vec4(rays.tmax[r], 0.0, 0.0, uintBitsToFloat(NO_HIT));
    if (hits.slot[r] != NO_HIT)
      result = hitAt(rays.origin[r], rays.direction[r], rays.tmin[r], hits.slot[r]);
    outputOf[numberOf(r)] = stored(result);
  }
}

void traceRays() {
  const Rays rays = readRays();
  writeHits(rays, closest(rays));
}

// All rays of a workgroup get the origin of its first ray.
void traceFromOne() {
  Rays rays = readRays();
  if (R != 1u) {
    const vec3 origin = texelVec3(texelFetch(inputTexels, int(groupNumber() * 64u) * 2));
    FOR_RAYS (uint r = 0u; r < R; ++r) rays.origin[r] = origin;
  }
  writeHits(rays, closestFromOne(rays));
}

void main() {
  QUERY();
  if (loopsWereCut()) atomicAdd(status.incomplete, 1u);
}
