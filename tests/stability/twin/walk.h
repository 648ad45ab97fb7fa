#pragma once
#include <array>

#include "bvh/bvh.h"
#include "shared/box.h"

namespace laver::test {

/// The walk of shaders/lane_walk.glsl over the tree that buildBvh made. `box(lo, hi)` gives the
/// span of depths inside a box; `leaf(triangle, last)` may lower `last` and returns true to end the
/// walk.
template <class BoxTest, class LeafTest>
void walk(const Bvh& bvh, glm::vec3 direction, float last, const BoxTest& box,
          const LeafTest& leaf) {
  struct Entry {
    std::uint32_t ref;
    float depth;
  };
  std::array<Entry, 512> stack;
  std::size_t size = 0;
  const std::uint32_t octant = (direction.x < 0.0F ? 1U : 0U) | (direction.y < 0.0F ? 2U : 0U) |
                               (direction.z < 0.0F ? 4U : 0U);
  if (bvh.root != shared::REF_NONE) stack[size++] = {bvh.root, -INFINITY};
  while (size > 0) {
    const Entry next = stack[--size];
    if (!(next.depth <= last)) continue;
    if (next.ref >= shared::REF_LEAF) {
      std::uint32_t slot = next.ref & shared::REF_INDEX_MASK, more = 0;
      do {
        if (leaf(bvh.triangles[slot], last)) return;
        more = bvh.triangles[slot++].more;
      } while (more > 0);
      continue;
    }
    for (std::uint32_t turn = shared::NODE_WIDTH; turn-- > 0;) {
      const shared::Child& child = bvh.nodes[next.ref].child[turn ^ octant];
      if (child.ref == shared::REF_NONE) continue;
      const shared::BoxSpan span = box(child.lo, child.hi);
      if (span.near <= span.far && span.depth <= last) stack.at(size++) = {child.ref, span.depth};
    }
  }
}

}  // namespace laver::test
