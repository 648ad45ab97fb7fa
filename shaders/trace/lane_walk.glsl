// The walk of a single ray: each lane of a subgroup walks with its own ray and stack.
//
// Depths are distances along the ray's dominant axis k (triangle.h). Since loops are `do … while` on most devices
// (DO: texel_buffers.glsl), a walk enters the root even for an inactive ray, and tests a triangle even if no leaf
// is left.
//
// Which hit wins must not depend on the tree, so a node is skipped only if its box, grown sideways by a pad,
// misses the line (box.h), or lies completely nearer than tmin or farther than the best hit.
#include "resources.glsl"
#include "trace/lane_stack.glsl"
#include "trace/rays.glsl"
#include "trace/caps.glsl"
#include "trace/far_points.glsl"
#include "trace/plane.glsl"
#include "shared/box.h"
#include "shared/sphere.h"

struct LaneRay {
  vec3 origin;
  BoxRay box;
  Shear shear;
  uint octant;
  float first;                 // depth at tmin
};

LaneRay laneRay(vec3 origin, vec3 direction, float tmin) {
  LaneRay ray;
  ray.origin = origin;
  ray.shear = shearOf(direction);
  ray.box = boxRayOf(origin, direction, ray.shear.axis);
  ray.octant = (direction.x < 0.0 ? 1u : 0u) | (direction.y < 0.0 ? 2u : 0u) |
               (direction.z < 0.0 ? 4u : 0u);
  ray.first = tmin * abs(alongAxis(direction, ray.shear.axis));
  return ray;
}

// Tests the children of a node and returns the next reference, given that hits beyond depth `last` are not
// needed.
uint enterNode(LaneRay ray, uint node, float last) {
  Children children;
  children.hit = 0u;
  [[unroll]] for (uint step = 0u; step < NODE_WIDTH; ++step) {
    const int texel = int((node * NODE_WIDTH + (step ^ ray.octant)) * 2u);
    const uvec4 low = texelFetch(nodeTexels, texel);
    const uvec4 high = texelFetch(nodeTexels, texel + 1);
    const BoxSpan span = boxSpan(ray.box, ray.first, texelVec3(low), texelVec3(high));
    const bool hit = span.near <= span.far && span.depth <= last && low.w != REF_NONE;
    children.hit |= hit ? 1u << step : 0u;
    children.ref[step] = low.w;
    children.depth[step] = span.depth;
  }
  return enter(children, last);
}

struct LaneTriangle {
  vec3 a, b, c;           // as stored
  vec3 pa, pb, pc;        // permuted, relative to the origin
  uint id, more;
  bool sphere;  // radius b.x
  vec2 ends;    // of a sphere: the depths of its front and back
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
  t.sphere = HAS_SPHERES && c.w == IS_SPHERE;
  t.ends = endsOf(permute(ray.shear, t.a).z, t.b.x, permute(ray.shear, ray.origin).z);
  return t;
}

// Whether a ray that starts on a surface goes towards the triangle's plane: by the sides of that plane, as
// for shadow rays (blocks()), since rounding may give a hit on the ray's own surface any depth near 0.
bool isAhead(LaneRay ray, vec3 direction, LaneTriangle t) {
  const vec3 a = permute(ray.shear, t.a);
  const vec3 n = planeNormal(permute(ray.shear, t.b) - a, permute(ray.shear, t.c) - a);
  const float side = dotProduct(n, t.pa), along = dotProduct(n, permute(ray.shear, direction));
  return (side > 0.0 && along > 0.0) || (side < 0.0 && along < 0.0);
}

// Tests the primitive of a slot and updates the nearest hit. Returns how many of its leaf follow.
uint testSlot(LaneRay ray, vec3 direction, uint slot, inout float last, inout uint best, inout uint bestId) {
  const LaneTriangle t = loadTriangle(ray, slot);
  Edges e = edgesOf(ray.shear, t.pa, t.pb, t.pc);
  float depth = depthOf(e, t.pa.z, t.pb.z, t.pc.z);
  if (HAS_FAR_PARTS) e.inside = e.inside && passesCorners(ray.shear, t.pa, t.pb, t.pc);
  if (HAS_SPHERES && t.sphere) {
    const Chord chord = chordOf(ray.shear, t.pa, t.ends, t.b.x);
    depth = depthOn(chord, ray.first);
    e.inside = chord.hit;
    if (BOUNCES && ray.first == 0.0) {
      const bool startsOutside = outside(t.pa, t.b.x);
      e.inside = chord.hit && (!startsOutside || chord.middle > 0.0);
      depth = greater(startsOutside ? chord.near : chord.far, 0.0);
    }
  } else if (BOUNCES && ray.first == 0.0) {
    e.inside = e.inside && isAhead(ray, direction, t);
    depth = greater(depth, 0.0);
  }
  // Equal depths: the smaller id, that is file order.
  if (e.inside && depth >= ray.first && depth <= last && (depth < last || t.id < bestId)) {
    last = depth;
    best = slot;
    bestId = t.id;
  }
  return t.more;
}

bool isLeaf(uint ref) { return ref >= REF_LEAF && ref != REF_NONE; }
uint rootOfWalk() { return WALKS_PORTIONS ? pass.root : params.root; }

// The slot of the nearest primitive that the ray hits, or NO_HIT, where `known` is the nearest of an earlier
// portion of the tree, or NO_HIT.
uint closestLane(vec3 origin, vec3 direction, float tmin, float tmax, bool isActive, uint known) {
  const LaneRay ray = laneRay(origin, direction, tmin);
  float last = isActive ? tmax * abs(alongAxis(direction, ray.shear.axis)) : NEVER;
  uint best = NO_HIT, bestId = NO_HIT;
  if (WALKS_PORTIONS) {
    // Caps are tested in each portion.
    const bool inTree = known != NO_HIT && (!HAS_CAPS || known < params.firstCap);
    if (inTree) testSlot(ray, direction, known, last, best, bestId);
  }
  if (HAS_CAPS)
    meetCaps(origin, direction, abs(alongAxis(direction, ray.shear.axis)), ray.first, last, best,
             bestId);
  uint ref = rootOfWalk();
  stacked = 0u;
  DO(ref != REF_NONE) {
    DO(ref < REF_LEAF) ref = enterNode(ray, ref, last); WHILE(ref < REF_LEAF);
    DO(isLeaf(ref)) {
      uint slot = slotOf(ref), more = 1u;
      DO(more > 0u) {
        more = testSlot(ray, direction, slot, last, best, bestId);
        slot++;
      } WHILE(more > 0u);
      ref = pop(last);
    } WHILE(isLeaf(ref));
  } WHILE(ref != REF_NONE);
  return best;
}

// Whether no primitive blocks the segment from a point along `direction`, which with `toLight` ends at
// `light`. It is traced from the point: geometry near the point is decisive, and its rounding error must not
// grow with the light's distance. See far_points.glsl for the exception.
bool unoccludedLane(vec3 point, vec3 direction, bool toLight, vec3 light, bool isActive) {
  bool blocked = false;
  if (HAS_CAPS) blocked = capsBlock(point, toLight ? light : point + direction);
  if (HAS_FAR_PARTS && toLight && isFarPoint(point, light)) {
    const vec3 end = point;
    point = light;
    light = end;
    direction = light - point;
  }
  const LaneRay ray = laneRay(point, direction, 0.0);
  // The depth of the end; the slack covers the rounding of light - point.
  const float last =
      isActive && !blocked ? alongAxis(abs(direction), ray.shear.axis) * DEPTH_SLACK : NEVER;
  uint ref = rootOfWalk();
  stacked = 0u;
  DO(ref != REF_NONE) {
    DO(ref < REF_LEAF) ref = enterNode(ray, ref, last); WHILE(ref < REF_LEAF);
    DO(isLeaf(ref)) {
      uint slot = slotOf(ref), more = 1u;
      DO(more > 0u) {
        const LaneTriangle t = loadTriangle(ray, slot);
        const vec3 a = permute(ray.shear, t.a);
        const vec3 n = planeNormal(permute(ray.shear, t.b) - a, permute(ray.shear, t.c) - a);
        const float lightSide = dotProduct(n, permute(ray.shear, light) - a);
        bool between =
            toLight ? blocks(ray.shear, last, n, lightSide, t.pa, t.pb, t.pc)
                    : blocksSegment(ray.shear, last, permute(ray.shear, direction), n, t.pa, t.pb, t.pc);
        if (HAS_FAR_PARTS) between = between && passesCorners(ray.shear, t.pa, t.pb, t.pc);
        if (HAS_SPHERES && t.sphere) {
          const vec3 end =
              toLight ? permute(ray.shear, light) - a : permute(ray.shear, direction) - t.pa;
          between = sphereBlocks(ray.shear, last, t.pa, end, t.ends, t.b.x);
        }
        blocked = blocked || between;
        more = blocked ? 0u : t.more;
        slot++;
      } WHILE(more > 0u);
      if (blocked) stacked = 0u;
      ref = pop(last);
    } WHILE(isLeaf(ref));
  } WHILE(ref != REF_NONE);
  return isActive && !blocked;
}
