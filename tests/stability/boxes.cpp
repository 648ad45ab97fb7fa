// Rays that hit a box exactly must hit it in float: at its edges, in its faces, with components
// that are tiny or zero of either sign, far from the origin.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "lab/chart/methods/quantise.h"
#include "stability/exact.h"
#include "stability/meshes.h"
#include "stability/naive.h"
#include "stability/record.h"
#include "unit/box.h"

namespace laver::test {
namespace {

using glm::vec3;

/// A node's tight box, and the box that the builder grew from it.
struct TreeBox {
  Box tight, grown;
};

/// The boxes of the builder's tree over small triangles, a third of them flat in one axis.
std::vector<TreeBox> treeBoxes(float offset) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-1.0F, 1.0F), side(-0.05F, 0.05F);
  std::vector<shared::Triangle> triangles;
  for (std::uint32_t id = 0; id < 4096; ++id) {
    const auto point = [&](auto& d) { return vec3(d(random), d(random), d(random)); };
    const vec3 a = point(place);
    vec3 b = a + point(side), c = a + point(side);
    if (id % 3 == 0) {
      const int axis = static_cast<int>(random() % 3);
      b[axis] = c[axis] = a[axis];
    }
    triangles.push_back({a + offset, id, b + offset, 0, c + offset, 0});
  }
  const Bvh grown = buildBvh(triangles);
  const Bvh tight = chart::withTightBoxes(grown);
  std::vector<TreeBox> boxes;
  for (std::size_t n = 0; n < grown.nodes.size(); ++n)
    for (std::size_t c = 0; c < shared::NODE_WIDTH; ++c)
      if (grown.nodes[n].child[c].ref != shared::REF_NONE) {
        const auto &t = tight.nodes[n].child[c], &g = grown.nodes[n].child[c];
        boxes.push_back({{t.lo, t.hi}, {g.lo, g.hi}});
      }
  return boxes;
}

enum class Kind { Edges, InAFace, TinyComponent, ZeroComponent };
constexpr const char* kNames[] = {"box edges", "in a face", "tiny components", "zero components"};

struct TestRay {
  vec3 origin, direction;
};

TestRay rayAt(const Box& box, Kind kind, float offset, std::mt19937& random) {
  std::uniform_real_distribution<float> place(-1.0F, 1.0F), unit(0.0F, 1.0F);
  TestRay ray;
  vec3 target;
  for (int a = 0; a < 3; ++a) {
    ray.origin[a] = offset + place(random);
    target[a] = (random() & 1U) != 0 ? box.lo[a] : box.hi[a];
  }
  const int free = static_cast<int>(random() % 3);
  target[free] = box.lo[free] + unit(random) * (box.hi[free] - box.lo[free]);
  if (kind == Kind::Edges) {
    ray.direction = target - ray.origin;
    return ray;
  }
  // One or two axes along which the ray hardly moves, starting inside the slab or on its face.
  const int still = static_cast<int>(random() % 3), also = static_cast<int>(random() % 3);
  for (const int a : {still, also}) ray.origin[a] = target[a];
  ray.direction = target - ray.origin;
  for (const int a : {still, also}) {
    if (kind == Kind::InAFace) ray.direction[a] = 0.0F;
    if (kind == Kind::ZeroComponent) {
      ray.direction[a] = (random() & 1U) != 0 ? 0.0F : -0.0F;
      ray.origin[a] = box.lo[a] + unit(random) * (box.hi[a] - box.lo[a]);
    }
    if (kind == Kind::TinyComponent)
      ray.direction[a] = place(random) * std::pow(10.0F, -15.0F - 30.0F * unit(random));
  }
  return ray;
}

LAVER_STABILITY(Boxes, "Slabs: box edges, faces, tiny components, signed zeros, far offsets") {
  for (const float offset : {0.0F, 1e6F}) {
    const std::vector<TreeBox> boxes = treeBoxes(offset);
    for (const Kind kind : {Kind::Edges, Kind::InAFace, Kind::TinyComponent, Kind::ZeroComponent}) {
      for (const Twin* twin : twins()) {
        std::atomic<std::uint64_t> hits = 0, naiveMisses = 0, misses = 0;
        forBatches(
            amount(full, 1ULL << 18, 1ULL << 23), 1ULL << 14, 0,
            [&](std::uint64_t, std::mt19937& random) {
              for (int i = 0; i < 1 << 14; ++i) {
                const TreeBox& box = boxes[random() % boxes.size()];
                const TestRay ray = rayAt(box.tight, kind, offset, random);
                if (ray.direction == vec3(0.0F) ||
                    !exact::intersects(ray.origin, ray.direction, box.tight.lo, box.tight.hi))
                  continue;
                ++hits;
                if (!naive::slabs(ray.origin, ray.direction, box.tight.lo, box.tight.hi))
                  ++naiveMisses;
                if (!twin->box(ray.origin, ray.direction, box.grown.lo, box.grown.hi)) ++misses;
              }
            });
        record.add(
            {std::string(kNames[static_cast<int>(kind)]) + (offset == 0.0F ? "" : ", offset 1e6"),
             twin->name, hits, static_cast<double>(naiveMisses), static_cast<double>(misses), 0.0,
             "false misses"});
      }
    }
  }
}

}  // namespace
}  // namespace laver::test
