#pragma once
#include <span>

#include "bvh/binary.h"
#include "bvh/bvh.h"

namespace laver {

/// Collapses a binary tree by its CollapseChoices and writes it, with its triangles, in the
/// device's layout.
Bvh flatten(const BinaryTree& tree, std::span<const shared::Triangle> triangles, unsigned threads);

}  // namespace laver
