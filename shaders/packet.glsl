// The `packet` traversal: a subgroup of 8 lanes traces 8 R rays through one walk of the tree. Lane c
// tests child c of a node, or triangle c of a leaf, against the frustum of all rays; each lane then
// picks the triangles that its own rays may meet and tests those with the text that `lane` uses. A
// frustum holds every hit that `lane` accepts (padOf), so both find the same.
#ifndef LAVER_PACKET_GLSL
#define LAVER_PACKET_GLSL
#include "packet_alone.glsl"
#include "packet_walk.glsl"

Hits closest(Rays rays) {
  Shear shears[R];
  float first[R], last[R];
  uint best[R], bestId[R];
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    shears[r] = shearOf(rays.direction[r]);
    first[r] = rays.tmin[r] * abs(alongAxis(rays.direction[r], shears[r].axis));
    best[r] = bestId[r] = NO_HIT;
    waiting |= rays.live[r] ? 1u << r : 0u;
  }

  Frustum f, own;
  do {
    const uint group = gatherGroup(shears, waiting, f, own);
    const vec3 origin = permute(f.axis, rays.origin);
    const float pad = padOf(rays.origin);
    own.window = f.window = vec4(origin.xy - pad, origin.xy + pad);
    own.depth = f.depth = origin.z;
    own.first = 3.4e38;
    own.last = NEVER;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool walks = (group >> r & 1u) != 0u;
      const float scale = abs(alongAxis(rays.direction[r], shears[r].axis));
      last[r] = walks ? rays.tmax[r] * scale : NEVER;
      own.first = walks ? lesser(first[r], own.first) : own.first;
      own.last = greater(last[r], own.last);
    }
    f.first = minOfLanes(own.first);
    f.last = maxOfLanes(own.last);

    stackSize = 0;
    uint ref = params.film.w;
    do {
      do ref = enterNode(f, ref); while (ref < REF_LEAF);
      do {
        uint slot, mine;
        const LeafTriangle leaf = loadLeaf(f, own, ref, slot, mine);
        do {
          const uint from = nextOf(mine);
          const vec3 a = fromLane(leaf.a, from) - origin;
          const vec3 b = fromLane(leaf.b, from) - origin;
          const vec3 c = fromLane(leaf.c, from) - origin;
          const uint id = subgroupShuffle(leaf.id, from);
#ifdef LAVER_SPHERES
          const float radius = subgroupShuffle(leaf.radius, from);
          const vec2 ends = endsOf(subgroupShuffle(leaf.a.z, from), radius, origin.z);
#endif
          FOR_RAYS (uint r = 0u; r < R; ++r) {
            Edges e = edgesOf(shears[r], a, b, c);
            float depth = depthOf(e, a.z, b.z, c.z);
#ifdef LAVER_SPHERES
            const Chord chord = chordOf(shears[r], a, ends, radius);
            depth = radius > 0.0 ? depthOn(chord, first[r]) : depth;
            e.inside = radius > 0.0 ? chord.met : e.inside;
#endif
            // Equal depths: the smaller id, that is file order.
            const bool nearer = e.inside && depth >= first[r] &&
                                (depth < last[r] || (depth == last[r] && id < bestId[r]));
            last[r] = nearer ? depth : last[r];
            best[r] = nearer ? slot + from : best[r];
            bestId[r] = nearer ? id : bestId[r];
          }
        } while (orOfLanes(mine) != 0u);
        own.last = NEVER;
        FOR_RAYS (uint r = 0u; r < R; ++r) own.last = greater(last[r], own.last);
        f.last = maxOfLanes(own.last);
        ref = pop();
      } while (ref >= REF_LEAF && ref != REF_NONE);
    } while (ref != REF_NONE);
  } while (orOfLanes(waiting) != 0u);
  Hits hits;
  FOR_RAYS (uint r = 0u; r < R; ++r) hits.slot[r] = best[r];
  return hits;
}

// Beyond this distance from the centre of the scene's box of half-width 1, a light is far.
const float FAR_LIGHT = 4.0;

// The walk goes from the light, which all rays share; but floats count from the origin, so from a
// far light the frustum would be all padding. Then rays are nearly parallel, and the walk goes from
// the points: rays are bounded by their slopes and by where they cross the nearest point's depth.
// The triangle tests are made from the points, as in `lane`.
void visible(vec3 light, vec3 points[R], bool live[R], out bool seen[R]) {
  const float farthest = greater(abs(light.x), greater(abs(light.y), abs(light.z)));
  const bool distant = farthest > FAR_LIGHT;
  // From the light it is the same line with its direction turned.
  const float turn = distant ? 1.0 : -1.0;
  Shear shears[R], walks[R];
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const Shear s = shearOf(light - points[r]);
    shears[r] = s;
    walks[r] = Shear(s.axis, turn * s.sign, turn * s.u, turn * s.v);
    waiting |= live[r] ? 1u << r : 0u;
  }
  uint open = waiting;

  Frustum f, own;
  do {
    const uint group = gatherGroup(walks, waiting, f, own);
    // The group's points and the light as the points' own shears see them.
    const Shear axis = Shear(f.axis.axis, turn * f.axis.sign, 0.0, 0.0);
    const vec3 lamp = permute(axis, light);
    vec3 from[R];
    float last[R];
    float nearest = 3.4e38;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool walking = (group >> r & 1u) != 0u;
      from[r] = permute(axis, points[r]);
      last[r] = walking ? (lamp.z - from[r].z) * DEPTH_SLACK : NEVER;
      nearest = walking ? lesser(nearest, from[r].z) : nearest;
    }
    nearest = minOfLanes(nearest);

    own.window = vec4(3.4e38, 3.4e38, NEVER, NEVER);
    own.last = NEVER;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool walking = (group >> r & 1u) != 0u;
      const float ahead = distant ? from[r].z - nearest : 0.0;
      const vec4 wider = hull(own.window, from[r].xy - vec2(walks[r].u, walks[r].v) * ahead);
      own.window = walking ? wider : own.window;
      own.last = walking ? greater(own.last, ahead + last[r]) : own.last;
    }
    // With padOf's e and A: lines through the points miss the light by the rounding of d and of its
    // slopes, 7 e A; the triangle test at a point errs by 11 e 2; a blocker may seem to lie behind
    // the light by 16 e A, which moves it sideways by as much; this walk errs by 3 e A: 48 in all.
    // From the points, crossings err by 5 e 2 instead of the first and the third.
    const float pad = 3.0 * padOf(vec3(distant ? nearest : farthest, 0.0, 0.0));
    own.depth = distant ? nearest : -lamp.z;
    own.window = (distant ? own.window : lamp.xyxy) + vec4(-pad, -pad, pad, pad);
    own.first = -pad;
    own.last = own.last * DEPTH_SLACK + pad;
    f.window = hullOfLanes(own.window);
    f.depth = own.depth;
    f.first = own.first;
    f.last = maxOfLanes(own.last);

    stackSize = 0;
    uint ref = params.film.w;
    do {
      do ref = enterNode(f, ref); while (ref < REF_LEAF);
      do {
        uint slot, mine;
        const LeafTriangle leaf = loadLeaf(f, own, ref, slot, mine);
        do {
          const uint lender = nextOf(mine);
          const vec3 way = vec3(1.0, 1.0, turn);
          const vec3 a = fromLane(leaf.a, lender) * way;
          const vec3 b = fromLane(leaf.b, lender) * way;
          const vec3 c = fromLane(leaf.c, lender) * way;
          const vec3 n = crossProduct(b - a, c - a);
          const float lightSide = dotProduct(n, lamp - a);
#ifdef LAVER_SPHERES
          const float radius = subgroupShuffle(leaf.radius, lender);
#endif
          FOR_RAYS (uint r = 0u; r < R; ++r) {
            bool blocked = blocks(shears[r], last[r], n, lightSide, a - from[r],
                                  b - from[r], c - from[r]);
#ifdef LAVER_SPHERES
            const bool byBall = ballBlocks(shears[r], last[r], a - from[r], lamp - a,
                                           endsOf(a.z, radius, from[r].z), radius);
            blocked = radius > 0.0 ? byBall : blocked;
#endif
            open &= blocked ? ~(1u << r) : ~0u;
          }
        } while (orOfLanes(mine) != 0u);
        own.last = (group & open) == 0u ? NEVER : own.last;
        f.last = maxOfLanes(own.last);
        const uint next = pop();
        ref = f.last == NEVER ? REF_NONE : next;
      } while (ref >= REF_LEAF && ref != REF_NONE);
    } while (ref != REF_NONE);
  } while (orOfLanes(waiting) != 0u);
  FOR_RAYS (uint r = 0u; r < R; ++r) seen[r] = (open >> r & 1u) != 0u;
}

#endif
