#pragma once
#include <span>
#include <vector>

#include "bench/embree_scene.h"
#include "bvh/bvh.h"
#include "unit/box.h"

namespace laver::bench {

/// A node (no triangles) or a leaf of any tree, with the box that its parent stores.
struct CostItem {
  test::Box box;
  std::uint32_t triangles;
};

/// SAH cost of a tree: the expected cost of a random line that hits the root, with the costs of
/// host/bvh/wide.h. The first item is the root.
double sahCost(std::span<const CostItem> items);

std::vector<CostItem> costItems(const Bvh& bvh);

/// The tree that rtcBuildBVH builds for the mesh with laver's branching, leaf size and costs.
std::vector<CostItem> embreeTree(const EmbreeDevice& device, const EmbreeMesh& mesh,
                                 RTCBuildQuality quality);

}  // namespace laver::bench
