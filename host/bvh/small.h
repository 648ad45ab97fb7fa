#pragma once
#include "bvh/binary.h"

namespace laver {

/// Ranges of at most this many items are divided optimally: at minimum SAH cost over all binary
/// trees.
inline constexpr std::uint32_t kSmallItems = 4;

/// Builds the subtree `s` of 1 to kSmallItems `items`, which may be the items of `s` itself.
Forest buildSmall(const BuildItem* items, const Subtree& s, BinaryTree& tree);

}  // namespace laver
