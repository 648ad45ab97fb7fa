#pragma once
#include "bvh/binary.h"

namespace laver {

/// Ranges of at most this many items are divided at least SAH cost over all ways to divide them.
inline constexpr std::uint32_t kFew = 4;

/// Builds the subtree `s` of 1 to kFew `items`, which may be its own.
Forest buildFew(const BuildItem* items, const Subtree& s, BinaryTree& tree);

}  // namespace laver
