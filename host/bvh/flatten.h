#pragma once
#include <span>

#include "bvh/binary.h"
#include "bvh/bvh.h"

namespace laver {

/// Collapses a binary tree as its choices say and writes it, with the triangles that its items
/// name, in the device's layout.
Bvh flatten(const BinaryTree& tree, std::span<const shared::Triangle> triangles, unsigned threads);

}  // namespace laver
