#version 460
#extension GL_GOOGLE_include_directive : require
// Rays from memory, hits to memory, by the production traversals: the nearest hits of rays, or with
// LAVER_VISIBLE whether points see a light. A workgroup takes 64 of them.
#ifdef LAVER_PACKET
#include "packet.glsl"
#else
#include "lane.glsl"
#endif
#include "resources.glsl"
#include "shared/point.h"

layout(local_size_x = 64 / R) in;
// Ray: origin, tmin; direction, tmax. Point: xyz, -.
layout(binding = BINDINGS) uniform usamplerBuffer inputTexels;
#ifdef LAVER_VISIBLE
layout(binding = BINDINGS + 1) writeonly buffer SeenBlock { uint seenOf[]; };
#else
layout(binding = BINDINGS + 1) writeonly buffer HitBlock { Stored hitOf[]; };  // t, u, v, id
#endif
// Here Pass holds: region.x the count; core.xyz the light, as bits of floats.

uint groupNumber() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint numberOf(uint r) { return groupNumber() * 64u + gl_LocalInvocationIndex * R + r; }

#ifdef LAVER_VISIBLE
void main() {
  vec3 points[R];
  bool live[R], seen[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const bool given = numberOf(r) < pass.region.x;
    const uvec4 point = texelFetch(inputTexels, int(given ? numberOf(r) : 0u));
    points[r] = texelVec3(point);
    live[r] = given && (point.x & 0x7fffffffu) <= 0x7f800000u;
  }
  visible(uintBitsToFloat(pass.core.xyz), points, live, seen);
  FOR_RAYS (uint r = 0u; r < R; ++r)
    if (numberOf(r) < pass.region.x) seenOf[numberOf(r)] = seen[r] ? 1u : 0u;
  if (loopsWereCut()) atomicAdd(status.incomplete, 1u);
}
#else
vec4 hitAt(vec3 origin, vec3 direction, float tmin, uint slot) {
  const int texel = int(slot * 3u);
  const uvec4 first = texelFetch(triangleTexels, texel);
  const vec3 a = texelVec3(first);
  const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
  const uvec4 last = texelFetch(triangleTexels, texel + 2);
  Point p = pointAt(origin, direction, a, b, texelVec3(last), false);
#ifdef LAVER_SPHERES
  if (last.w == IS_SPHERE) p = ballPointAt(origin, direction, tmin, a, b.x);
#endif
  return vec4(p.t, p.weights.yz, uintBitsToFloat(first.w));
}

void main() {
  Rays rays;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    rays.live[r] = numberOf(r) < pass.region.x;
    const int texel = int(rays.live[r] ? numberOf(r) : 0u) * 2;
    const uvec4 start = texelFetch(inputTexels, texel), way = texelFetch(inputTexels, texel + 1);
    rays.tmin[r] = uintBitsToFloat(start.w);
    rays.direction[r] = texelVec3(way);
    rays.tmax[r] = uintBitsToFloat(way.w);
    if (R == 1u) rays.origin = texelVec3(start);
  }
  if (R != 1u) rays.origin = texelVec3(texelFetch(inputTexels, int(groupNumber() * 64u) * 2));
  const Hits hits = closest(rays);
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (!rays.live[r]) continue;
    vec4 result = vec4(rays.tmax[r], 0.0, 0.0, uintBitsToFloat(NO_HIT));
    if (hits.slot[r] != NO_HIT) result = 
          hitAt(rays.origin, rays.direction[r], rays.tmin[r], hits.slot[r]);
    hitOf[numberOf(r)] = stored(result);
  }
  if (loopsWereCut()) atomicAdd(status.incomplete, 1u);
}
#endif
