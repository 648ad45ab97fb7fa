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
  std::uint32_t depth = 0;                          ///< number of nodes on the longest path
  std::uint32_t stack = 1;  ///< maximum number of entries of a traversal's stack
  double sahCost = 0;       ///< with kNodeCost and kTriangleCost (wide.h)
  std::uint32_t leaves = 0;
};

/// Builds the tree of triangles and spheres with set `id`s and finite coordinates. Throws
/// Error(Device) if there are more than a child reference can address.
Bvh buildBvh(std::span<const shared::Triangle> triangles, unsigned threads = 0);

}  // namespace laver
