// Compiled several times into separate shared libraries, so that the linker does not merge inline
// functions that were compiled with different options. LAVER_TWIN is the name of the exported
// function, LAVER_TWIN_NAME names the options.
#include "stability/twin/twin.h"

#include "bvh/walk.h"

namespace laver::test {
namespace {

using namespace shared;

/// The kernels' condition for entering a box.
bool enters(const BoxSpan& span, float last) { return span.near <= span.far && span.depth <= last; }

TestHit closestOne(const Bvh& bvh, const TestRay& r) {
  const Shear shear = shearOf(r.direction);
  const BoxRay ray = boxRayOf(r.origin, r.direction, shear.axis);
  const float scale = std::abs(alongAxis(r.direction, shear.axis));
  const float first = r.tmin * scale;
  float last = r.tmax * scale;
  const Triangle* best = nullptr;
  walk(
      bvh, octantOf(r.direction),
      [&](const Child& child) { return enters(boxSpan(ray, first, child.lo, child.hi), last); },
      [&](const Triangle& t) {
        const vec3 pa = permute(shear, t.a - r.origin), pb = permute(shear, t.b - r.origin);
        const vec3 pc = permute(shear, t.c - r.origin);
        const Edges e = edgesOf(shear, pa, pb, pc);
        float depth = depthOf(e, pa.z, pb.z, pc.z);
        bool hit = e.inside;
        if (t.flipped == IS_SPHERE) {
          const vec2 ends = endsOf(permute(shear, t.a).z, t.b.x, permute(shear, r.origin).z);
          const Chord chord = chordOf(shear, pa, ends, t.b.x);
          depth = depthOn(chord, first);
          hit = chord.hit;
        }
        if (hit && depth >= first && depth <= last &&
            (depth < last || best == nullptr || t.id < best->id)) {
          last = depth;
          best = &t;
        }
        return false;
      });
  if (best == nullptr) return {r.tmax, 0.0F, 0.0F, NO_HIT};
  const Point p =
      best->flipped == IS_SPHERE
          ? spherePointAt(r.origin, r.direction, r.tmin, best->a, best->b.x)
          : pointAt(r.origin, r.direction, best->a, best->b, best->c, best->flipped != 0);
  return {p.t, p.weights.y, p.weights.z, best->id};
}

void closest(const Bvh& bvh, std::span<const TestRay> rays, TestHit* hits) {
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closestOne(bvh, rays[i]);
}

bool visibleOne(const Bvh& bvh, vec3 light, vec3 point) {
  const vec3 direction = light - point;
  const Shear shear = shearOf(direction);
  const BoxRay ray = boxRayOf(point, direction, shear.axis);
  const float end = std::abs(alongAxis(direction, shear.axis)) * (1.0F + 2.4e-7F);
  return !walk(
      bvh, octantOf(direction),
      [&](const Child& child) { return enters(boxSpan(ray, 0.0F, child.lo, child.hi), end); },
      [&](const Triangle& t) {
        if (t.flipped == IS_SPHERE) {
          const vec2 ends = endsOf(permute(shear, t.a).z, t.b.x, permute(shear, point).z);
          return sphereBlocks(shear, end, permute(shear, t.a - point),
                              permute(shear, light) - permute(shear, t.a), ends, t.b.x);
        }
        const vec3 n = permute(shear, crossProduct(t.b - t.a, t.c - t.a));
        const float side = dotProduct(n, permute(shear, light) - permute(shear, t.a));
        return blocks(shear, end, n, side, permute(shear, t.a - point), permute(shear, t.b - point),
                      permute(shear, t.c - point));
      });
}

void visible(const Bvh& bvh, vec3 light, std::span<const vec3> points, std::uint32_t* seen) {
  for (std::size_t i = 0; i < points.size(); ++i)
    seen[i] = visibleOne(bvh, light, points[i]) ? 1U : 0U;
}

Point point(vec3 origin, vec3 direction, const Triangle& t) {
  if (t.flipped == IS_SPHERE) return spherePointAt(origin, direction, 0.0F, t.a, t.b.x);
  return pointAt(origin, direction, t.a, t.b, t.c, t.flipped != 0);
}

bool box(vec3 origin, vec3 direction, vec3 lo, vec3 hi) {
  const BoxSpan span = boxSpan(boxRayOf(origin, direction, shearOf(direction).axis), 0.0F, lo, hi);
  return span.near <= span.far;
}

bool inside(vec3 origin, vec3 direction, const Triangle& t) {
  const Shear shear = shearOf(direction);
  return edgesOf(shear, permute(shear, t.a - origin), permute(shear, t.b - origin),
                 permute(shear, t.c - origin))
      .inside;
}

constexpr Twin kTwin{LAVER_TWIN_NAME, closest, visible, point, box, inside};

}  // namespace

[[gnu::visibility("default")]] const Twin* LAVER_TWIN();
const Twin* LAVER_TWIN() { return &kTwin; }

}  // namespace laver::test
