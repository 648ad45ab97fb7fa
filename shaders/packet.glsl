// The `packet` traversal: a subgroup of 8 lanes traces 64 rays, 8 a lane, through one walk of the
// tree. Lane c tests child c of a node, or triangle c of a leaf, against the frustum of the rays;
// triangles that stay are handed to all lanes and tested by every ray with the text that `lane`
// uses. The frustum holds every hit that `lane` accepts (see padOf), so both find the same.
#ifndef LAVER_PACKET_GLSL
#define LAVER_PACKET_GLSL
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "rays.glsl"
#include "resources.glsl"
#include "shared/triangle.h"

// Rays walk together whose slopes differ from the leader's by no more than this: wide frusta meet
// too much of the tree.
const float WINDOW = 0.02;

uint lane() { return gl_SubgroupInvocationID; }

float minOfLanes(float x) {
  x = min(x, subgroupShuffleXor(x, 1u));
  x = min(x, subgroupShuffleXor(x, 2u));
  return min(x, subgroupShuffleXor(x, 4u));
}
float maxOfLanes(float x) { return -minOfLanes(-x); }
uint orOfLanes(uint x) {
  x |= subgroupShuffleXor(x, 1u);
  x |= subgroupShuffleXor(x, 2u);
  return x | subgroupShuffleXor(x, 4u);
}
// Bounds of pairs: lowest in xy, highest in zw.
vec4 hull(vec4 bounds, vec2 x) { return vec4(min(bounds.xy, x), max(bounds.zw, x)); }
vec4 hullOfLanes(vec4 bounds) {
  return vec4(minOfLanes(bounds.x), minOfLanes(bounds.y), maxOfLanes(bounds.z),
              maxOfLanes(bounds.w));
}
vec3 fromLane(vec3 v, uint from) {
  return vec3(subgroupShuffle(v.x, from), subgroupShuffle(v.y, from), subgroupShuffle(v.z, from));
}

// All rays of one walk, relative to `origin`: at depth z, 0 <= z, a ray stands between
// slopes.xy * z - slack.xy and slopes.zw * z + slack.zw, and its hits lie between two depths.
struct Frustum {
  vec3 origin;
  uint axis;
  float sign;
  vec4 slopes;  // lowest u and v, highest u and v
  vec4 slack;
  float first, last;
};

// Sideways padding of boxes and triangles, with e = 2^-24, A = max |origin| + 1: a triangle test
// made at the origin errs by less than 11 e A (lane.glsl), products of slope and depth by e A, box
// corners by e A: below 16 e A.
float padOf(vec3 origin) {
  return 9.5367432e-7 * (max(abs(origin.x), max(abs(origin.y), abs(origin.z))) + 1.0);
}

// May a box, permuted and relative to the origin, hold a hit?
bool meets(Frustum f, vec3 low, vec3 high) {
  const float near = max(low.z, f.first), far = min(high.z, f.last);
  const vec2 lowest = min(f.slopes.xy * near, f.slopes.xy * far) - f.slack.xy;
  const vec2 highest = max(f.slopes.zw * near, f.slopes.zw * far) + f.slack.zw;
  return near <= far && all(lessThanEqual(lowest, high.xy)) &&
         all(greaterThanEqual(highest, low.xy));
}

Shear axisOf(Frustum f) { return Shear(f.axis, f.sign, 0.0, 0.0); }

// The stack is one for the subgroup, which is the workgroup.
shared uint stackRef[STACK];
uint stackSize;

uint pop() {
  if (stackSize == 0u) return endWalk();
  stackSize--;
  return stackRef[stackSize];
}

// One step of a bitonic sort across lanes, ascending where `up`.
uint exchange(uint key, uint distance, bool up) {
  const uint other = subgroupShuffleXor(key, distance);
  const bool lower = (lane() & distance) == 0u;
  return lower == up ? min(key, other) : max(key, other);
}

// Pushes the children of a node that the frustum meets and returns the nearest.
uint enterNode(Frustum f, uint node) {
  const int texel = int((node * NODE_WIDTH + lane()) * 2u);
  const uvec4 low = texelFetch(nodeTexels, texel);
  const uvec4 high = texelFetch(nodeTexels, texel + 1);
  const vec3 a = permute(axisOf(f), texelVec3(low) - f.origin);
  const vec3 b = permute(axisOf(f), texelVec3(high) - f.origin);
  // Where the sign is negative the high corner is nearer.
  const vec3 near = vec3(a.xy, min(a.z, b.z)), far = vec3(b.xy, max(a.z, b.z));
  const bool hit = low.w != REF_NONE && meets(f, near, far);

  // Depths are not negative, so their bits sort like them; the last three name the lane.
  uint key = hit ? (floatBitsToUint(max(near.z, 0.0)) & ~7u) | lane() : REF_NONE;
  const bool second = (lane() & 2u) == 0u, third = (lane() & 4u) == 0u;
  key = exchange(key, 1u, second);
  key = exchange(key, 2u, third);
  key = exchange(key, 1u, third);
  key = exchange(key, 4u, true);
  key = exchange(key, 2u, true);
  key = exchange(key, 1u, true);

  const uint ref = subgroupShuffle(low.w, key & 7u);
  const bool valid = key != REF_NONE;
  uint count = valid ? 1u : 0u;
  count += subgroupShuffleXor(count, 1u);
  count += subgroupShuffleXor(count, 2u);
  count += subgroupShuffleXor(count, 4u);
  if (count == 0u) return pop();
  incomplete = incomplete || stackSize + count - 1u > STACK;
  if (valid && lane() != 0u && !incomplete) stackRef[stackSize + count - 1u - lane()] = ref;
  memoryBarrierShared();
  stackSize = incomplete ? 0u : stackSize + count - 1u;
  return incomplete ? REF_NONE : subgroupShuffle(ref, 0u);
}

// The triangle that this lane holds of a leaf, and which lanes' triangles the frustum meets.
struct LeafTriangle {
  vec3 a, b, c;
  uint id;
};

LeafTriangle loadLeaf(Frustum f, uint ref, out uint slot, out uint meeting) {
  slot = ref & REF_INDEX_MASK;
  // Lanes beyond the leaf's end read what follows; the count of lane 0 says which they are.
  const int last = textureSize(triangleTexels) / 3 - 1;
  const int texel = min(int(slot + lane()), last) * 3;
  const uvec4 a = texelFetch(triangleTexels, texel);
  const uvec4 b = texelFetch(triangleTexels, texel + 1);
  const uvec4 c = texelFetch(triangleTexels, texel + 2);
  const LeafTriangle t = LeafTriangle(texelVec3(a), texelVec3(b), texelVec3(c), a.w);
  const vec3 pa = permute(axisOf(f), t.a - f.origin);
  const vec3 pb = permute(axisOf(f), t.b - f.origin);
  const vec3 pc = permute(axisOf(f), t.c - f.origin);
  const bool mine = lane() <= subgroupShuffle(b.w, 0u);
  const bool hit = mine && meets(f, min(pa, min(pb, pc)), max(pa, max(pb, pc)));
  meeting = orOfLanes(hit ? 1u << lane() : 0u);
  return t;
}

// The lowest lane, and in it the lowest ray, that still waits. Returns false if none does.
bool leaderOf(uint waiting, out uint leadLane, out uint leadRay) {
  const uint lanes = orOfLanes(waiting != 0u ? 1u << lane() : 0u);
  leadLane = uint(findLSB(lanes));
  leadRay = subgroupShuffle(uint(findLSB(waiting)), leadLane & 7u);
  return lanes != 0u;
}

// Takes the rays that may walk with the leader out of `waiting` and bounds their slopes.
uint gatherGroup(Shear shears[R], inout uint waiting, uint leadLane, uint leadRay, inout Frustum f) {
  Shear lead = shears[0];
  [[unroll]] for (uint r = 1u; r < R; ++r) {
    if (r == leadRay) lead = shears[r];
  }
  f.axis = subgroupShuffle(lead.axis, leadLane);
  f.sign = subgroupShuffle(lead.sign, leadLane);
  const float u = subgroupShuffle(lead.u, leadLane), v = subgroupShuffle(lead.v, leadLane);
  uint group = 0u;
  f.slopes = vec4(2.0, 2.0, -2.0, -2.0);
  [[unroll]] for (uint r = 0u; r < R; ++r) {
    const Shear s = shears[r];
    const bool leads = lane() == leadLane && r == leadRay;
    const bool joins = leads || ((waiting >> r & 1u) != 0u && s.axis == f.axis &&
                                 s.sign == f.sign && max(abs(s.u - u), abs(s.v - v)) <= WINDOW);
    group |= joins ? 1u << r : 0u;
    f.slopes = joins ? hull(f.slopes, vec2(s.u, s.v)) : f.slopes;
  }
  f.slopes = hullOfLanes(f.slopes);
  waiting &= ~group;
  return group;
}

Hits closest(Rays rays) {
  Shear shears[R];
  float first[R], last[R];
  uint best[R], bestId[R];
  uint waiting = 0u;
  [[unroll]] for (uint r = 0u; r < R; ++r) {
    shears[r] = shearOf(rays.direction[r]);
    const float scale = abs(alongAxis(rays.direction[r], shears[r].axis));
    first[r] = rays.tmin[r] * scale;
    last[r] = rays.tmax[r] * scale;
    best[r] = bestId[r] = NO_HIT;
    waiting |= rays.live[r] ? 1u << r : 0u;
  }

  Frustum f;
  f.origin = rays.origin;
  f.slack = vec4(padOf(rays.origin));
  uint leadLane, leadRay;
  while (leaderOf(waiting, leadLane, leadRay) && !incomplete) {
    iterations++;
    const uint group = gatherGroup(shears, waiting, leadLane, leadRay, f);
    f.first = 3.4e38;
    f.last = -1.0;
    [[unroll]] for (uint r = 0u; r < R; ++r) {
      const bool walks = (group >> r & 1u) != 0u;
      f.first = walks ? min(f.first, first[r]) : f.first;
      f.last = walks ? max(f.last, last[r]) : f.last;
    }
    f.first = minOfLanes(f.first);
    f.last = maxOfLanes(f.last);

    stackSize = 0u;
    uint ref = params.film.w;
    ended = ref == REF_NONE;
    while (working(ref)) {
      while (ref < REF_LEAF && working(ref)) ref = enterNode(f, ref);
      while (ref >= REF_LEAF && working(ref)) {
        uint slot, meeting;
        const LeafTriangle mine = loadLeaf(f, ref, slot, meeting);
        while (meeting != 0u) {
          iterations++;
          const uint c = uint(findLSB(meeting));
          meeting &= meeting - 1u;
          const Shear axis = axisOf(f);
          const vec3 pa = permute(axis, fromLane(mine.a, c) - f.origin);
          const vec3 pb = permute(axis, fromLane(mine.b, c) - f.origin);
          const vec3 pc = permute(axis, fromLane(mine.c, c) - f.origin);
          const uint id = subgroupShuffle(mine.id, c);
          [[unroll]] for (uint r = 0u; r < R; ++r) {
            const Edges e = edgesOf(shears[r], pa, pb, pc);
            const float depth = depthOf(e, pa.z, pb.z, pc.z);
            const bool nearer = (group >> r & 1u) != 0u && e.inside && depth >= first[r] &&
                                depth <= last[r] && (depth < last[r] || id < bestId[r]);
            last[r] = nearer ? depth : last[r];
            best[r] = nearer ? slot + c : best[r];
            bestId[r] = nearer ? id : bestId[r];
          }
        }
        f.last = -1.0;
        [[unroll]] for (uint r = 0u; r < R; ++r)
          f.last = (group >> r & 1u) != 0u ? max(f.last, last[r]) : f.last;
        f.last = maxOfLanes(f.last);
        ref = pop();
      }
    }
    incomplete = incomplete || !ended;
  }
  incomplete = incomplete || waiting != 0u;
  Hits hits;
  [[unroll]] for (uint r = 0u; r < R; ++r) hits.slot[r] = best[r];
  return hits;
}

// Beyond this distance from the centre of the scene's box of half-width 1, a light is far.
const float FAR_LIGHT = 4.0;

// The walk goes from the light, which all rays share; but floats count from the origin, so from a
// far light the frustum would be all padding. Then rays are nearly parallel, and the walk goes from
// the points: rays are bounded by their slopes and by where they cross the nearest point's depth.
// The triangle tests are made from the points, as in `lane`.
void visible(vec3 light, vec3 points[R], bool live[R], out bool seen[R]) {
  const bool distant = max(abs(light.x), max(abs(light.y), abs(light.z))) > FAR_LIGHT;
  Shear shears[R], walks[R];
  float last[R];
  uint waiting = 0u;
  [[unroll]] for (uint r = 0u; r < R; ++r) {
    const vec3 d = light - points[r];
    const Shear s = shearOf(d);
    shears[r] = s;
    last[r] = alongAxis(abs(d), s.axis) * (1.0 + 2.4e-7);
    // From the light it is the same line with its direction turned.
    walks[r] = Shear(s.axis, distant ? s.sign : -s.sign, distant ? s.u : -s.u,
                     distant ? s.v : -s.v);
    waiting |= live[r] ? 1u << r : 0u;
  }
  uint open = waiting;

  Frustum f;
  uint leadLane, leadRay;
  while (leaderOf(waiting, leadLane, leadRay) && !incomplete) {
    iterations++;
    const uint group = gatherGroup(walks, waiting, leadLane, leadRay, f);
    // The group's points as their own shears see them; permuting before subtracting changes no bit.
    const Shear axis = Shear(f.axis, distant ? f.sign : -f.sign, 0.0, 0.0);
    vec3 from[R];
    float nearest = 3.4e38;
    [[unroll]] for (uint r = 0u; r < R; ++r) {
      from[r] = permute(axis, points[r]);
      nearest = (group >> r & 1u) != 0u ? min(nearest, from[r].z) : nearest;
    }
    nearest = minOfLanes(nearest);

    f.last = -1.0;
    vec4 crossings = vec4(3.4e38, 3.4e38, -3.4e38, -3.4e38);
    [[unroll]] for (uint r = 0u; r < R; ++r) {
      const bool walksHere = (group >> r & 1u) != 0u;
      const float ahead = distant ? from[r].z - nearest : 0.0;
      const vec2 crossing = from[r].xy - vec2(walks[r].u, walks[r].v) * ahead;
      crossings = walksHere ? hull(crossings, crossing) : crossings;
      f.last = walksHere ? max(f.last, ahead + last[r]) : f.last;
    }
    crossings = hullOfLanes(crossings);
    // With padOf's e and A: lines through the points miss the light by the rounding of d and of its
    // slopes, 7 e A; the triangle test at a point errs by 11 e 2; a blocker may seem to lie behind
    // the light by 16 e A, which moves it sideways by as much; this walk errs by 2 e A: 47 in all.
    // From the points, crossings err by 5 e 2 instead of the first and the third.
    if (distant) {
      const float z = nearest * f.sign;
      f.origin = vec3(f.axis == 0u ? z : 0.0, f.axis == 1u ? z : 0.0, f.axis == 2u ? z : 0.0);
    } else {
      f.origin = light;
    }
    const float pad = 3.0 * padOf(f.origin);
    f.slack = distant ? vec4(pad - crossings.xy, pad + crossings.zw) : vec4(pad);
    f.first = -padOf(f.origin);
    f.last = maxOfLanes(f.last) * (1.0 + 2.4e-7) + pad;
    stackSize = 0u;
    uint ref = params.film.w;
    ended = ref == REF_NONE;
    while (working(ref)) {
      while (ref < REF_LEAF && working(ref)) ref = enterNode(f, ref);
      while (ref >= REF_LEAF && working(ref)) {
        uint slot, meeting;
        const LeafTriangle mine = loadLeaf(f, ref, slot, meeting);
        while (meeting != 0u) {
          iterations++;
          const uint c = uint(findLSB(meeting));
          meeting &= meeting - 1u;
          const vec3 a = fromLane(mine.a, c), b = fromLane(mine.b, c), d = fromLane(mine.c, c);
          const vec3 n = permute(axis, crossProduct(b - a, d - a));
          const vec3 pa = permute(axis, a), pb = permute(axis, b), pc = permute(axis, d);
          const float lightSide = dotProduct(n, permute(axis, light) - pa);
          [[unroll]] for (uint r = 0u; r < R; ++r) {
            const bool blocked = blocks(shears[r], last[r], n, lightSide, pa - from[r],
                                        pb - from[r], pc - from[r]);
            open &= blocked && (group >> r & 1u) != 0u ? ~(1u << r) : ~0u;
          }
        }
        ref = orOfLanes(group & open) == 0u ? endWalk() : pop();
      }
    }
    incomplete = incomplete || !ended;
  }
  incomplete = incomplete || waiting != 0u;
  [[unroll]] for (uint r = 0u; r < R; ++r) seen[r] = (open >> r & 1u) != 0u;
}

#endif
