// Shadow rays of a packet to one light.
#include "trace/caps.glsl"
#include "trace/packet_leaf.glsl"
#include "trace/packet_pairs.glsl"

// Distance from the centre of the scene's box of half-width 1 beyond which a light is far.
const float FAR_LIGHT = 4.0;

// A triangle of a leaf in the points' permuted space, and the light's side of its plane.
struct Blocker {
  vec3 a, b, c;
  vec3 normal;
  float lightSide;
  float radius;  // of a sphere, else 0
};

Blocker blockerOf(LeafTriangle leaf, uint from, vec3 light, float toLight) {
  const vec3 mirror = vec3(1.0, 1.0, toLight);
  Blocker t;
  t.a = fromLane(leaf.a, from) * mirror;
  t.b = fromLane(leaf.b, from) * mirror;
  t.c = fromLane(leaf.c, from) * mirror;
  t.normal = planeNormal(t.b - t.a, t.c - t.a);
  t.lightSide = dotProduct(t.normal, light - t.a);
  t.radius = 0.0;
  if (HAS_SPHERES) t.radius = subgroupShuffle(leaf.radius, from);
  return t;
}

// The segment from `from` to `end`, which is the light unless points are far.
bool isBlocked(Blocker t, Shear shear, vec3 from, float last, vec3 end) {
  float endSide = t.lightSide;
  if (HAS_FAR_PARTS) endSide = dotProduct(t.normal, end - t.a);
  bool blocked = blocks(shear, last, t.normal, endSide, t.a - from, t.b - from, t.c - from);
  if (HAS_FAR_PARTS)
    blocked = blocked && passesCorners(shear, t.a - from, t.b - from, t.c - from);
  if (HAS_SPHERES) {
    const bool bySphere =
        sphereBlocks(shear, last, t.a - from, end - t.a, endsOf(t.a.z, t.radius, from.z), t.radius);
    blocked = t.radius > 0.0 ? bySphere : blocked;
  }
  return blocked;
}

// The walk starts at the light, which all rays share. From a far light, however, the frustum would be mostly
// padding, since float positions are relative to the origin. The rays are then nearly parallel, and the walk
// starts at the points: rays are bounded by their slopes and by where they cross the depth of the nearest
// point. Triangle tests are relative to the points, as in `lane`, and for far points (far_points.glsl) to the
// light.
void unoccludedToOne(vec3 light, vec3 points[R], bool isActive[R], out bool clear[R]) {
  const bool distant = largestAxis(light) > FAR_LIGHT;
  Shear shears[R], walks[R];
  uint waiting = 0u, farPoints = 0u;
  float farthest = 1.0;  // of the points
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    bool towardsLight = distant;
    bool blocked = false;
    Shear s = shearOf(light - points[r]);
    if (HAS_CAPS) blocked = capsBlock(points[r], light);
    if (HAS_FAR_PARTS && isFarPoint(points[r], light)) {
      s = shearOf(points[r] - light);
      farPoints |= 1u << r;
      towardsLight = true;
    }
    // Where the walk goes away from the light along lines towards it, all signs are turned.
    const float turned = towardsLight ? 1.0 : -1.0;
    shears[r] = s;
    walks[r] = Shear(s.axis, turned * s.sign, turned * s.u, turned * s.v);
    waiting |= isActive[r] && !blocked ? 1u << r : 0u;
  }
  uint open = waiting;

  Frustum f, own;
  do {
    // Rays from the light walk after all others.
    const bool farGroup = HAS_FAR_PARTS && orOfLanes(waiting & ~farPoints) == 0u;
    uint candidates = waiting;
    if (HAS_FAR_PARTS && !farGroup) candidates &= ~farPoints;
    const uint group = formGroup(walks, candidates, f, own);
    waiting &= ~group;
    const bool fromPoints = distant && !farGroup;
    // 1 where the walk goes along the rays of the triangle tests, -1 where it goes against them.
    const float along = fromPoints || farGroup ? 1.0 : -1.0;
    // The group's points and the light, permuted by the rays' own shears.
    const Shear axis = Shear(f.axis.axis, along * f.axis.sign, 0.0, 0.0);
    const vec3 permutedLight = permute(axis, light);
    vec3 from[R], end[R];
    float last[R];
    float nearest = 3.4e38;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool walking = (group >> r & 1u) != 0u;
      const vec3 point = permute(axis, points[r]);
      from[r] = farGroup ? permutedLight : point;
      end[r] = farGroup ? point : permutedLight;
      last[r] = walking ? (end[r].z - from[r].z) * DEPTH_SLACK : NEVER;
      nearest = walking ? lesser(nearest, from[r].z) : nearest;
      if (HAS_FAR_PARTS && walking) farthest = greater(farthest, largestAxis(points[r]));
    }
    nearest = minOfLanes(nearest);

    own.window = vec4(3.4e38, 3.4e38, NEVER, NEVER);
    own.last = NEVER;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool walking = (group >> r & 1u) != 0u;
      const float ahead = fromPoints ? from[r].z - nearest : 0.0;
      const vec4 wider = hull(own.window, from[r].xy - vec2(walks[r].u, walks[r].v) * ahead);
      own.window = walking ? wider : own.window;
      own.last = walking ? greater(own.last, ahead + last[r]) : own.last;
    }
    // With padOf's e, for a point p, a light l and a corner v: lines through the points miss the
    // light by the rounding of d and of its slopes, 7 e (|p| + |l|); the triangle test at a point errs
    // by 11 e (|v| + |p|); a blocker may seem to lie behind the light by 16 e (|v| + |p|), which moves
    // it sideways by as much; this walk errs by 3 e (|v| + |l|): 34 e |p| and 10 e |l| in all, and 30
    // e |v|, for which boxes are grown. From the points, crossings err by 5 e |p| instead of the first
    // and the third. From the light, for far points, there is no first.
    if (HAS_FAR_PARTS) {
      const float largest = maxOfLanes(farthest);
      farthest = farGroup ? 0.0 : largest;
    }
    const float lightSize = fromPoints ? 0.0 : largestAxis(light);
    const float pad = 3.0 * padOf(vec3(lightSize + farthest, 0.0, 0.0)) + 2.0 * TRIANGLE_PAD;
    own.depth = fromPoints ? nearest : along * permutedLight.z;
    own.window = (fromPoints ? own.window : permutedLight.xyxy) + vec4(-pad, -pad, pad, pad);
    own.first = -pad;
    own.last = own.last * DEPTH_SLACK + pad;
    f.window = hullOfLanes(own.window);
    f.depth = own.depth;
    f.first = own.first;
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
          uint done = 0u, blocked = 0u;  // R bits per lane
          do {
            const uint pair = pairAt(pairs, done + lane());
            const uint owner = pair >> 3;
            const Blocker t = blockerOf(leaf, pair & 7u, permutedLight, along);
            FOR_RAYS (uint r = 0u; r < R; ++r) {
              vec3 target = permutedLight;
              if (HAS_FAR_PARTS) target = fromLane(end[r], owner);
              const bool hidden = isBlocked(t, fromLane(shears[r], owner), fromLane(from[r], owner),
                                            subgroupShuffle(last[r], owner), target);
              blocked |= hidden ? 1u << (R * owner + r) : 0u;
            }
            done += 8u;
          } while (done < pairs.total);
          open &= ~(orOfLanes(blocked) >> (R * lane()));
        } else {
          do {
            const Blocker t = blockerOf(leaf, nextOf(mine), permutedLight, along);
            FOR_RAYS (uint r = 0u; r < R; ++r)
              open &= isBlocked(t, shears[r], from[r], last[r], end[r]) ? ~(1u << r) : ~0u;
          } while (orOfLanes(mine) != 0u);
        }
        own.last = (group & open) == 0u ? NEVER : own.last;
        f.last = maxOfLanes(own.last);
        const uint next = pop();
        ref = f.last == NEVER ? REF_NONE : next;
      } while (ref >= REF_LEAF && ref != REF_NONE);
    } while (ref != REF_NONE);
  } while (orOfLanes(waiting) != 0u);
  FOR_RAYS (uint r = 0u; r < R; ++r) clear[r] = (open >> r & 1u) != 0u;
}
