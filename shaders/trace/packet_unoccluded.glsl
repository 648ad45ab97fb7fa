// Shadow rays of a packet to one light.
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
  t.normal = crossProduct(t.b - t.a, t.c - t.a);
  t.lightSide = dotProduct(t.normal, light - t.a);
  t.radius = 0.0;
  if (HAS_SPHERES) t.radius = subgroupShuffle(leaf.radius, from);
  return t;
}

bool isBlocked(Blocker t, Shear shear, vec3 from, float last, vec3 light) {
  bool blocked =
      blocks(shear, last, t.normal, t.lightSide, t.a - from, t.b - from, t.c - from);
  if (HAS_SPHERES) {
    const bool bySphere =
        sphereBlocks(shear, last, t.a - from, light - t.a, endsOf(t.a.z, t.radius, from.z), t.radius);
    blocked = t.radius > 0.0 ? bySphere : blocked;
  }
  return blocked;
}

// The walk starts at the light, which all rays share. From a far light, however, the frustum would be mostly
// padding, since float positions are relative to the origin. The rays are then nearly parallel, and the walk
// starts at the points: rays are bounded by their slopes and by where they cross the depth of the nearest
// point. Triangle tests are always relative to the points, as in `lane`.
void unoccludedToOne(vec3 light, vec3 points[R], bool isActive[R], out bool clear[R]) {
  const float farthest = greater(abs(light.x), greater(abs(light.y), abs(light.z)));
  const bool distant = farthest > FAR_LIGHT;
  // 1 if the walk goes towards the light, -1 if it goes away from it along the same lines.
  const float toLight = distant ? 1.0 : -1.0;
  Shear shears[R], walks[R];
  uint waiting = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const Shear s = shearOf(light - points[r]);
    shears[r] = s;
    walks[r] = Shear(s.axis, toLight * s.sign, toLight * s.u, toLight * s.v);
    waiting |= isActive[r] ? 1u << r : 0u;
  }
  uint open = waiting;

  Frustum f, own;
  do {
    const uint group = formGroup(walks, waiting, f, own);
    // The group's points and the light, permuted by the points' shears.
    const Shear axis = Shear(f.axis.axis, toLight * f.axis.sign, 0.0, 0.0);
    const vec3 permutedLight = permute(axis, light);
    vec3 from[R];
    float last[R];
    float nearest = 3.4e38;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool walking = (group >> r & 1u) != 0u;
      from[r] = permute(axis, points[r]);
      last[r] = walking ? (permutedLight.z - from[r].z) * DEPTH_SLACK : NEVER;
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
    // slopes, 7 e A; the triangle test at a point errs by 11 e 2; a blocker may appear behind the
    // light by 16 e A, which moves it sideways by as much; this walk errs by 3 e A: 48 in all. From
    // the points, crossings err by 5 e 2 instead of the first and the third.
    const float pad = 3.0 * padOf(vec3(distant ? nearest : farthest, 0.0, 0.0));
    own.depth = distant ? nearest : -permutedLight.z;
    own.window = (distant ? own.window : permutedLight.xyxy) + vec4(-pad, -pad, pad, pad);
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
            const Blocker t = blockerOf(leaf, pair & 7u, permutedLight, toLight);
            FOR_RAYS (uint r = 0u; r < R; ++r) {
              const bool hidden = isBlocked(t, fromLane(shears[r], owner), fromLane(from[r], owner),
                                        subgroupShuffle(last[r], owner), permutedLight);
              blocked |= hidden ? 1u << (R * owner + r) : 0u;
            }
            done += 8u;
          } while (done < pairs.total);
          open &= ~(orOfLanes(blocked) >> (R * lane()));
        } else {
          do {
            const Blocker t = blockerOf(leaf, nextOf(mine), permutedLight, toLight);
            FOR_RAYS (uint r = 0u; r < R; ++r)
              open &= isBlocked(t, shears[r], from[r], last[r], permutedLight) ? ~(1u << r) : ~0u;
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
