// The `packet` traversal: a subgroup of 8 lanes traces 64 rays, 8 a lane, through one walk of the
// tree. Lane c tests child c of a node, or triangle c of a leaf, against the frustum of the rays;
// triangles that stay are handed to all lanes and tested by every ray with the text that `lane`
// uses. The frustum holds every hit that `lane` accepts (see padOf), so both find the same.
#ifndef LAVER_PACKET_GLSL
#define LAVER_PACKET_GLSL
#include "frustum.glsl"
#include "packet_walk.glsl"
#include "rays.glsl"
#include "resources.glsl"
#include "shared/triangle.h"

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
