// The `lane` traversal: one ray an invocation, a stack of its own.
//
// Everything is measured by depth, the distance along the ray's dominant axis k (triangle.h).
// Which hit wins must not depend on the tree, so a node is left out only if
//  - its box, grown sideways by a pad, misses the line. The triangle test can accept a line that
//    passes a triangle by its own rounding. With e = 2^-24 and A = max |o| + 1 >= any |v - o|
//    (the host scales the scene into [-1, 1]^3): corner - origin errs by e A on two axes, the slope by 5 e (2.5 ulp a
//    division), shear product and difference by 2 e A, the edge functions by 3 e A, and this box
//    test by 4 e A: below pad = 16 e A in all; or
//  - it lies wholly nearer than tmin or farther than the best hit. Along k no pad is needed:
//    corners lie within the box, subtraction rounds monotonically and depthOf() stays between the
//    corners' depths.
#ifndef LAVER_LANE
#define LAVER_LANE
#include "resources.glsl"
#include "rays.glsl"
#include "shared/triangle.h"

uint stackRef[STACK];
float stackDepth[STACK];
uint stackSize;

struct LaneRay {
  vec3 origin;
  vec3 originLow, originHigh;  // origin moved by the pad against each side of a box
  vec3 reciprocal;             // depth gained for each unit along the three axes
  Shear shear;
  uint octant;
  float first;                 // depth at tmin
};

// |d[k]| / d[a] without infinities: a slope below 2^-100 moves no ray by a visible amount.
float depthPerUnit(float d, float scale) {
  const float huge = 1.2676506e30;  // 2^100
  const float q = abs(d) * huge > scale ? scale / d : huge;
  return abs(d) * huge > scale || d >= 0.0 ? q : -q;
}

LaneRay laneRay(vec3 origin, vec3 direction, float tmin) {
  LaneRay ray;
  ray.origin = origin;
  ray.shear = shearOf(direction);
  const float scale = abs(alongAxis(direction, ray.shear.axis));
  const float pad = 9.5367432e-7 * (max(abs(origin.x), max(abs(origin.y), abs(origin.z))) + 1.0);
  const vec3 padding = vec3(ray.shear.axis == 0u ? 0.0 : pad, ray.shear.axis == 1u ? 0.0 : pad,
                            ray.shear.axis == 2u ? 0.0 : pad);
  ray.originLow = origin + padding;
  ray.originHigh = origin - padding;
  ray.reciprocal = vec3(depthPerUnit(direction.x, scale), depthPerUnit(direction.y, scale),
                        depthPerUnit(direction.z, scale));
  ray.octant = (direction.x < 0.0 ? 1u : 0u) | (direction.y < 0.0 ? 2u : 0u) |
               (direction.z < 0.0 ? 4u : 0u);
  ray.first = tmin * scale;
  return ray;
}

// The next reference whose node can hold a hit no farther than `last`.
uint pop(float last) {
  while (stackSize > 0u) {
    stackSize--;
    iterations++;
    if (stackDepth[stackSize] <= last) return stackRef[stackSize];
  }
  return endWalk();
}

// Pushes the children of a node that the ray can meet up to depth `last`, the nearest on top.
void pushChildren(LaneRay ray, uint node, float last) {
  [[unroll]] for (uint turn = 8u; turn-- > 0u;) {
    const int texel = int((node * NODE_WIDTH + (turn ^ ray.octant)) * 2u);
    const uvec4 low = texelFetch(nodeTexels, texel);
    const uvec4 high = texelFetch(nodeTexels, texel + 1);
    precise vec3 t0 = (texelVec3(low) - ray.originLow) * ray.reciprocal;
    precise vec3 t1 = (texelVec3(high) - ray.originHigh) * ray.reciprocal;
    const vec3 enter = min(t0, t1), leave = max(t0, t1);
    const float depth = alongAxis(enter, ray.shear.axis);
    const float near = max(max(enter.x, enter.y), max(enter.z, ray.first));
    const float far = min(leave.x, min(leave.y, leave.z));
    if (near <= far && depth <= last && low.w != REF_NONE) {
      if (stackSize < STACK) {
        stackRef[stackSize] = low.w;
        stackDepth[stackSize] = depth;
        stackSize++;
      } else {
        incomplete = true;
      }
    }
  }
}

struct LaneTriangle {
  vec3 a, b, c;           // as stored
  vec3 pa, pb, pc;        // permuted, relative to the origin
  uint id, more;
};

LaneTriangle loadTriangle(LaneRay ray, uint slot) {
  const int texel = int(slot * 3u);
  const uvec4 a = texelFetch(triangleTexels, texel);
  const uvec4 b = texelFetch(triangleTexels, texel + 1);
  const uvec4 c = texelFetch(triangleTexels, texel + 2);
  LaneTriangle t;
  t.a = texelVec3(a);
  t.b = texelVec3(b);
  t.c = texelVec3(c);
  t.pa = permute(ray.shear, t.a - ray.origin);
  t.pb = permute(ray.shear, t.b - ray.origin);
  t.pc = permute(ray.shear, t.c - ray.origin);
  t.id = a.w;
  t.more = b.w;
  return t;
}

uint closestLane(vec3 origin, vec3 direction, float tmin, float tmax, bool live) {
  const LaneRay ray = laneRay(origin, direction, tmin);
  float last = tmax * abs(alongAxis(direction, ray.shear.axis));
  uint best = NO_HIT, bestId = NO_HIT;
  uint ref = live ? params.film.w : REF_NONE;
  stackSize = 0u;
  ended = ref == REF_NONE;
  while (working(ref)) {
    while (ref < REF_LEAF && working(ref)) {
      pushChildren(ray, ref, last);
      ref = pop(last);
    }
    while (ref >= REF_LEAF && working(ref)) {
      uint slot = ref & REF_INDEX_MASK;
      uint more;
      do {
        iterations++;
        const LaneTriangle t = loadTriangle(ray, slot);
        const Edges e = edgesOf(ray.shear, t.pa, t.pb, t.pc);
        const float depth = depthOf(e, t.pa.z, t.pb.z, t.pc.z);
        // Equal depths: the smaller id, that is file order.
        if (e.inside && depth >= ray.first && depth <= last && (depth < last || t.id < bestId)) {
          last = depth;
          best = slot;
          bestId = t.id;
        }
        more = t.more;
        slot++;
      } while (more > 0u);
      ref = pop(last);
    }
  }
  incomplete = incomplete || !ended;
  return best;
}

// Traced from the point: what lies near it decides, and rounding there must not grow with the
// light's distance.
bool visibleLane(vec3 light, vec3 point, bool live) {
  const LaneRay ray = laneRay(point, light - point, 0.0);
  // The light's own depth; the slack is the rounding of light - point.
  const float last = alongAxis(abs(light - point), ray.shear.axis) * (1.0 + 2.4e-7);
  bool blocked = false;
  uint ref = live ? params.film.w : REF_NONE;
  stackSize = 0u;
  ended = ref == REF_NONE;
  while (working(ref)) {
    while (ref < REF_LEAF && working(ref)) {
      pushChildren(ray, ref, last);
      ref = pop(last);
    }
    while (ref >= REF_LEAF && working(ref)) {
      uint slot = ref & REF_INDEX_MASK;
      uint more;
      do {
        iterations++;
        const LaneTriangle t = loadTriangle(ray, slot);
        const Edges e = edgesOf(ray.shear, t.pa, t.pb, t.pc);
        const vec3 n = permute(ray.shear, crossProduct(t.b - t.a, t.c - t.a));
        const float lightSide =
            dotProduct(n, permute(ray.shear, light) - permute(ray.shear, t.a));
        blocked = blocked || blocks(ray.shear, last, n, lightSide, t.pa, t.pb, t.pc);
        more = blocked ? 0u : t.more;
        slot++;
      } while (more > 0u);
      if (blocked) stackSize = 0u;
      ref = pop(last);
    }
  }
  incomplete = incomplete || !ended;
  return live && !blocked;
}

Hits closest(Rays rays) {
  Hits hits;
  for (uint r = 0u; r < R; ++r)
    hits.slot[r] =
        closestLane(rays.origin, rays.direction[r], rays.tmin[r], rays.tmax[r], rays.live[r]);
  return hits;
}

void visible(vec3 light, vec3 points[R], bool live[R], out bool seen[R]) {
  for (uint r = 0u; r < R; ++r) seen[r] = visibleLane(light, points[r], live[r]);
}

#endif
