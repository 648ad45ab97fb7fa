#pragma once
#include <cstdint>
#include <vector>

#include "bvh/bvh.h"

namespace laver {

/// Parts of a tree that together hold each leaf once.
struct Portions {
  UninitialisedVector<shared::Node> nodes;  ///< the tree's, then the roots of the portions
  std::vector<std::uint32_t> roots;
  std::uint32_t stack = 1;  ///< maximum number of entries of a traversal's stack
};

/// Portions of at most `primitives` each; `primitives` >= MAX_LEAF.
Portions portionsOf(const Bvh& bvh, std::uint32_t primitives);

}  // namespace laver
