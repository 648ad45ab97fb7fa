#pragma once
#include <cstdint>
#include <vector>

#include "bvh/binary.h"

namespace laver {

/// What a node costs against one triangle test, for every SAH figure of this folder.
inline constexpr float kNodeCost = 1.0F;
inline constexpr float kTriangleCost = 0.3F;

/// A node of up to eight children, each an index of a binary node: itself a wide node, or a leaf.
struct WideChild {
  std::uint32_t binary;
  bool leaf;
};
struct WideNode {
  std::uint32_t binary;
  std::vector<WideChild> children;
};

/// Collapses a binary tree into nodes of at most `width` children and leaves of at most `maxLeaf`
/// items with the least SAH cost, by dynamic programming (Ylitie, Karras and Laine, "Efficient
/// Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, section 3.1). Node 0
/// is the root, children follow their parents depth first. Empty if the root is best a leaf.
std::vector<WideNode> collapse(const std::vector<BinaryNode>& nodes, unsigned width,
                               unsigned maxLeaf);

}  // namespace laver
