#pragma once
#include <span>
#include <vector>

#include "bench/embree_scene.h"
#include "bvh/bvh.h"
#include "unit/box.h"

namespace laver::bench {

/// A node (no triangles) or a leaf of any tree, with the box that its parent keeps of it.
struct CostItem {
  test::Box box;
  std::uint32_t triangles;
};

/// SAH cost of a tree: what a random line that meets the root is expected to cost, with the costs
/// of host/bvh/wide.h. The first item is the root.
double sahCost(std::span<const CostItem> items);

std::vector<CostItem> costItems(const Bvh& bvh);

/// The tree that rtcBuildBVH makes of the mesh with laver's branching, leaves and costs.
std::vector<CostItem> embreeTree(const EmbreeDevice& device, const EmbreeMesh& mesh,
                                 RTCBuildQuality quality);

}  // namespace laver::bench
