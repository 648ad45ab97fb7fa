#pragma once
#include <random>

#include "bvh/bvh.h"

namespace laver::test {

/// Trees over the same triangles that a ray visits in another order.
Bvh withShuffledChildren(Bvh bvh, std::mt19937& random);
/// Built from the triangles in another order.
Bvh fromShuffledTriangles(std::span<const shared::Triangle> from, std::mt19937& random);
/// Nodes of two children: each node of up to eight children becomes a chain.
Bvh withTwoChildren(const Bvh& bvh);

}  // namespace laver::test
