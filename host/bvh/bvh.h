#pragma once
#include <cstdint>
#include <span>

#include "core/uninitialised.h"
#include "shared/layout.h"

namespace laver {

/// The tree of triangles and spheres in the layout of shaders/shared/layout.h.
struct Bvh {
  UninitialisedVector<shared::Node> nodes;
  UninitialisedVector<shared::Triangle> triangles;  ///< in the order of the leaves
  std::uint32_t root = 0;                           ///< always a node
  std::uint32_t depth = 0;                          ///< nodes on the longest path
  std::uint32_t stack = 1;                          ///< entries that a traversal can need at most
  double sahCost = 0;                               ///< with kNodeCost and kTriangleCost (wide.h)
  std::uint32_t leaves = 0;
};

/// Builds the tree of `triangles`, spheres among them, whose `id`s are set and whose coordinates
/// are finite. Throws Error(Device) if there are more than a reference can name.
Bvh buildBvh(std::span<const shared::Triangle> triangles, unsigned threads = 0);

}  // namespace laver
