// Nearest hits of a packet: rays of one origin, or of a far camera, which start on one plane.
#include "trace/caps.glsl"
#include "trace/packet_leaf.glsl"
#include "trace/packet_pairs.glsl"

// A triangle of a leaf, relative to `origin`, or, of a far camera's rays, as it is.
struct LeafTarget {
  vec3 a, b, c;
  uint id, slot;
  float radius;  // of a sphere, else 0
  vec2 ends;
};

LeafTarget targetOf(LeafTriangle leaf, uint from, vec3 origin) {
  LeafTarget t;
  if (FAR_CAMERA) origin = vec3(0.0);
  t.a = fromLane(leaf.a, from) - origin;
  t.b = fromLane(leaf.b, from) - origin;
  t.c = fromLane(leaf.c, from) - origin;
  t.id = subgroupShuffle(leaf.id, from);
  t.slot = subgroupShuffle(leaf.slot, from);
  t.radius = 0.0;
  t.ends = vec2(0.0);
  if (HAS_SPHERES) {
    t.radius = subgroupShuffle(leaf.radius, from);
    t.ends = endsOf(subgroupShuffle(leaf.a.z, from), t.radius, origin.z);
    if (FAR_CAMERA) t.ends.x = t.a.z;  // for seenFrom()
  }
  return t;
}

// What a ray from an origin of its own sees.
LeafTarget seenFrom(vec3 origin, LeafTarget t) {
  t.a -= origin;
  t.b -= origin;
  t.c -= origin;
  t.ends = endsOf(t.ends.x, t.radius, origin.z);
  return t;
}

bool hitsAt(LeafTarget t, Shear shear, float first, out float depth) {
  Edges e = edgesOf(shear, t.a, t.b, t.c);
  depth = depthOf(e, t.a.z, t.b.z, t.c.z);
  if (HAS_FAR_PARTS) e.inside = e.inside && passesCorners(shear, t.a, t.b, t.c);
  if (HAS_SPHERES) {
    const Chord chord = chordOf(shear, t.a, t.ends, t.radius);
    depth = t.radius > 0.0 ? depthOn(chord, first) : depth;
    e.inside = t.radius > 0.0 ? chord.hit : e.inside;
  }
  return e.inside && depth >= first;
}

// Updates the nearest hit of a ray, and the depth up to which it searches, with the result of one more
// triangle.
void keepNearer(bool hit, float depth, uint slot, uint id, inout float last, inout uint best,
                inout uint bestId) {
  // Equal depths: the smaller id, that is file order.
  const bool nearer = hit && (depth < last || (depth == last && id < bestId));
  last = nearer ? depth : last;
  best = nearer ? slot : best;
  bestId = nearer ? id : bestId;
}

// Rays of a far camera start near one another. Their frustum is bounded by their slopes and by where
// they cross the depth of the first start, whose rounding the pad holds three times over. Sets `from`
// to the permuted origins, and counts own.last from f.depth.
void boundOrigins(Rays rays, Shear shears[R], uint group, inout Frustum f, inout Frustum own,
                  out vec3 from[R]) {
  float depth = 3.4e38, size = 0.0;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    from[r] = permute(f.axis, rays.origin[r]);
    depth = (group >> r & 1u) != 0u ? lesser(depth, from[r].z) : depth;
    size = greater(size, largestAxis(rays.origin[r]));
  }
  f.depth = own.depth = minOfLanes(depth);
  const float pad = 3.0 * padOf(vec3(maxOfLanes(size), 0.0, 0.0)) + TRIANGLE_PAD;
  vec4 window = vec4(3.4e38, 3.4e38, NEVER, NEVER);
  own.last = NEVER;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const bool walks = (group >> r & 1u) != 0u;
    const float ahead = from[r].z - f.depth;
    const vec4 wider = hull(window, from[r].xy - vec2(shears[r].u, shears[r].v) * ahead);
    window = walks ? wider : window;
    const float last = rays.tmax[r] * abs(alongAxis(rays.direction[r], shears[r].axis));
    own.last = walks ? greater(own.last, ahead + last) : own.last;
  }
  own.window = window + vec4(-pad, -pad, pad, pad);
  f.window = hullOfLanes(own.window);
}

// Loops are not moved into functions, since functions that take arrays are slower.
Hits closestFromOne(Rays rays) {
  Shear shears[R];
  float first[R], last[R];
  uint best[R], bestId[R];
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    shears[r] = shearOf(rays.direction[r]);
    first[r] = rays.tmin[r] * abs(alongAxis(rays.direction[r], shears[r].axis));
    best[r] = bestId[r] = NO_HIT;
    waiting |= rays.isActive[r] ? 1u << r : 0u;
  }

  Frustum f, own;
  do {
    const uint group = formGroup(shears, waiting, f, own);
    const vec3 origin = permute(f.axis, rays.origin[0]);
    const float pad = padOf(rays.origin[0]) + TRIANGLE_PAD;
    own.window = f.window = vec4(origin.xy - pad, origin.xy + pad);
    own.depth = f.depth = origin.z;
    own.first = 3.4e38;
    own.last = NEVER;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool walks = (group >> r & 1u) != 0u;
      const float scale = abs(alongAxis(rays.direction[r], shears[r].axis));
      last[r] = walks ? rays.tmax[r] * scale : NEVER;
      if (HAS_CAPS)
        meetCaps(rays.origin[r], rays.direction[r], scale, first[r], last[r], best[r], bestId[r]);
      own.first = walks ? lesser(first[r], own.first) : own.first;
      own.last = greater(last[r], own.last);
    }
    vec3 from[R];
    if (FAR_CAMERA) {
      boundOrigins(rays, shears, group, f, own, from);
    } else {
      FOR_RAYS (uint r = 0u; r < R; ++r) from[r] = vec3(0.0);
    }
    f.first = minOfLanes(own.first);
    f.last = maxOfLanes(own.last);

    stackSize = 0;
    uint ref = params.root;
    do {
      do ref = enterNode(f, ref); while (ref < REF_LEAF);
      do {
        uint mine;
        const LeafTriangle leaf = loadLeaf(f, own, ref, mine);
        if (SHARES_TESTS) {
          const Pairs pairs = pairsOf(mine);
          uint done = 0u, next = pairs.begin;
          do {
            const uint pair = pairAt(pairs, done + lane());
            const uint owner = pair >> 3;
            const LeafTarget t = targetOf(leaf, pair & 7u, origin);
            float depths[R];
            uint hitMask = 0u;
            FOR_RAYS (uint r = 0u; r < R; ++r) {
              const float begin = subgroupShuffle(first[r], owner);
              LeafTarget seen = t;
              if (FAR_CAMERA) seen = seenFrom(fromLane(from[r], owner), t);
              hitMask |=
                  hitsAt(seen, fromLane(shears[r], owner), begin, depths[r]) ? 1u << r : 0u;
            }
            // Each lane takes the hits of its own rays.
            done += 8u;
            const uint end = min(pairs.end, done);
            do {
              const bool has = next < end;
              const uint by = next & 7u;
              const uint found = subgroupShuffle(hitMask, by);
              const uint hitSlot = subgroupShuffle(t.slot, by), id = subgroupShuffle(t.id, by);
              FOR_RAYS (uint r = 0u; r < R; ++r)
                keepNearer(has && (found >> r & 1u) != 0u, subgroupShuffle(depths[r], by), hitSlot, id,
                           last[r], best[r], bestId[r]);
              next += has ? 1u : 0u;
            } while (orOfLanes(next < end ? 1u : 0u) != 0u);
          } while (done < pairs.total);
        } else {
          do {
            const LeafTarget t = targetOf(leaf, nextOf(mine), origin);
            FOR_RAYS (uint r = 0u; r < R; ++r) {
              float depth;
              LeafTarget seen = t;
              if (FAR_CAMERA) seen = seenFrom(from[r], t);
              const bool hit = hitsAt(seen, shears[r], first[r], depth);
              keepNearer(hit, depth, t.slot, t.id, last[r], best[r], bestId[r]);
            }
          } while (orOfLanes(mine) != 0u);
        }
        own.last = NEVER;
        FOR_RAYS (uint r = 0u; r < R; ++r) {
          const float ahead = FAR_CAMERA && last[r] != NEVER ? from[r].z - f.depth : 0.0;
          own.last = greater(last[r] + ahead, own.last);
        }
        f.last = maxOfLanes(own.last);
        ref = pop();
      } while (ref >= REF_LEAF && ref != REF_NONE);
    } while (ref != REF_NONE);
  } while (orOfLanes(waiting) != 0u);
  Hits hits;
  FOR_RAYS (uint r = 0u; r < R; ++r) hits.slot[r] = best[r];
  return hits;
}
