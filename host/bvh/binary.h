#pragma once
#include <bit>
#include <cstdint>

#include "bvh/items.h"
#include "bvh/wide.h"
#include "core/uninitialised.h"

namespace laver {

/// A node of a binary tree, for two or more items.
struct alignas(16) BinaryNode {
  glm::vec3 lo;
  std::uint32_t leftCount;  ///< items of the left child
  glm::vec3 hi;
  CollapseChoices choices;  ///< of the collapse into wide nodes
  Box4 box() const { return std::bit_cast<Box4>(*this); }
};

/// Items [first, first + count) of a tree; with two or more, `node` is their node.
struct Subtree {
  std::uint32_t node, first, count;

  // A subtree of n items has n - 1 nodes, the left child's first.
  Subtree left(std::uint32_t leftCount) const { return {node + 1, first, leftCount}; }
  Subtree right(std::uint32_t leftCount) const {
    return {node + leftCount, first + leftCount, count - leftCount};
  }
};

struct BinaryTree {
  UninitialisedVector<BinaryNode> nodes;
  UninitialisedVector<BuildItem> items;  ///< in the order of the tree

  Subtree root() const { return {0, 0, static_cast<std::uint32_t>(items.size())}; }
  Subtree left(const Subtree& s) const { return s.left(nodes[s.node].leftCount); }
  Subtree right(const Subtree& s) const { return s.right(nodes[s.node].leftCount); }
  Box4 box(const Subtree& s) const {
    return s.count == 1 ? items[s.first].box : nodes[s.node].box();
  }
};

/// Subtrees of at most this many items are built by one thread.
inline constexpr std::uint32_t kTaskItems = 4096;
/// From this depth on, items are halved by count.
inline constexpr unsigned kSahDepth = 48;

/// Builds a tree of one or more items by binned SAH, down to single items. Below a depth that no
/// ordinary mesh reaches, items are halved by count, which bounds the depth by kSahDepth + log2(n).
/// The tree does not depend on the number of threads (0: all).
BinaryTree buildBinary(UninitialisedVector<BuildItem> items, unsigned threads);

}  // namespace laver
