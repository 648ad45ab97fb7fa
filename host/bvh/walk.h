#pragma once
#include <cstdint>
#include <vector>

#include "bvh/bvh.h"

namespace laver {

/// Calls visit(triangle) for the triangles of a leaf in slot order until a call returns true.
/// Returns whether one did.
template <class Visit>
bool anyTriangle(const Bvh& bvh, std::uint32_t leaf, const Visit& visit) {
  std::uint32_t slot = leaf & shared::REF_INDEX_MASK;
  for (;; ++slot) {
    const shared::Triangle& triangle = bvh.triangles[slot];
    if (visit(triangle)) return true;
    if (triangle.more == 0) return false;
  }
}

/// Calls visit(triangle) for all triangles of a leaf.
template <class Visit>
void forEachTriangle(const Bvh& bvh, std::uint32_t leaf, const Visit& visit) {
  anyTriangle(bvh, leaf, [&](const shared::Triangle& triangle) {
    visit(triangle);
    return false;
  });
}

/// Depth-first walk. enter(child) returns whether to visit a child's subtree or leaf; it is called
/// just before that, so that it can use earlier results. visit(triangle) is called for the
/// triangles of the entered leaves until a call returns true. Children are visited in the order of
/// `octant` (Node in shared/layout.h). Returns whether visit() ended the walk.
template <class Enter, class Visit>
bool walk(const Bvh& bvh, std::uint32_t octant, const Enter& enter, const Visit& visit) {
  std::vector<const shared::Child*> waiting;
  waiting.reserve(bvh.stack);
  std::uint32_t ref = bvh.root;
  for (;;) {
    if (ref < shared::REF_LEAF) {
      for (std::uint32_t step = shared::NODE_WIDTH; step-- > 0;) {
        const shared::Child& child = bvh.nodes[ref].child[step ^ octant];
        if (child.ref != shared::REF_NONE) waiting.push_back(&child);
      }
    } else if (ref != shared::REF_NONE && anyTriangle(bvh, ref, visit)) {
      return true;
    }
    const shared::Child* next = nullptr;
    do {
      if (waiting.empty()) return false;
      next = waiting.back();
      waiting.pop_back();
    } while (!enter(*next));
    ref = next->ref;
  }
}

/// The octant of a direction, by which a ray hits the children of most nodes front to back.
inline std::uint32_t octantOf(glm::vec3 direction) {
  return (direction.x < 0.0F ? 1U : 0U) | (direction.y < 0.0F ? 2U : 0U) |
         (direction.z < 0.0F ? 4U : 0U);
}

}  // namespace laver
