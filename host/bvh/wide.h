#pragma once
#include <array>
#include <cstdint>

#include "shared/layout.h"

namespace laver {

/// Costs of a node and of a triangle test, for every SAH cost in this folder.
inline constexpr float kNodeCost = 1.0F;
inline constexpr float kTriangleCost = 0.06F;

/// Minimum costs of a binary subtree collapsed into at most 1, 2 ... 8 wide trees (Ylitie, Karras
/// and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017,
/// section 3.1).
struct Forest {
  std::array<float, shared::NODE_WIDTH> cost;
};

/// How a subtree reaches its minimum costs, in nibbles. Nibble i > 0: the left child's share of i +
/// 1 trees, or 0 if one tree fewer is no more expensive. Nibble 0: the left child's share of trees
/// below a wide node here, or 0 if the whole subtree is best one leaf.
struct CollapseChoices {
  std::uint32_t nibbles;
  unsigned left(unsigned trees) const { return nibbles >> 4 * (trees - 1) & 15U; }
};

/// Of an item of half area `area`.
Forest oneItem(float area);

/// Two items of the given half areas below a box of half area `area`.
Forest twoItems(float area, float left, float right, CollapseChoices& choices);

/// Two subtrees of `leftCount` and `rightCount` items below a box of half area `area`.
Forest joined(const Forest& left, std::uint32_t leftCount, const Forest& right,
              std::uint32_t rightCount, float area, CollapseChoices& choices);

}  // namespace laver
