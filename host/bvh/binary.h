#pragma once
#include <cstdint>
#include <vector>

#include "bvh/box.h"

namespace laver {

/// A primitive to sort into a tree.
struct BuildItem {
  Box box;
  std::uint32_t id;
};

/// Node of a full binary tree over items [first, first + count); a leaf holds one item. Node 0 is
/// the root; the left child follows its parent.
struct BinaryNode {
  Box box;
  std::uint32_t first, count;
  std::uint32_t right;  ///< index of the right child
  std::uint32_t left(std::uint32_t self) const { return self + 1; }
};

/// Builds by binned SAH (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies",
/// 2007) down to single items, which it reorders: 2 n - 1 nodes. Below a depth that no ordinary
/// mesh reaches, items are halved by count, which bounds the depth by kSahDepth + log2(n). The
/// tree is the same for any number of threads (0: all).
std::vector<BinaryNode> buildBinary(std::vector<BuildItem>& items, unsigned threads);

inline constexpr unsigned kSahDepth = 48;

}  // namespace laver
