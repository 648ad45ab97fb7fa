#include "bench/embree_builds.h"

#include <algorithm>
#include <new>

#include "bvh/wide.h"

namespace laver::bench {
namespace {

struct TreeNode {
  std::uint32_t triangles = 0;  // of a leaf
  std::uint32_t count = 0;
  void* child[shared::NODE_WIDTH];
  test::Box box[shared::NODE_WIDTH];
};

void* createNode(RTCThreadLocalAllocator allocator, unsigned count, void*) {
  auto* node = new (rtcThreadLocalAlloc(allocator, sizeof(TreeNode), 16)) TreeNode;
  node->count = count;
  return node;
}

void setChildren(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<TreeNode*>(node)->child[i] = children[i];
}

void setBounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) {
    const RTCBounds& b = *bounds[i];
    static_cast<TreeNode*>(node)->box[i] = {{b.lower_x, b.lower_y, b.lower_z},
                                            {b.upper_x, b.upper_y, b.upper_z}};
  }
}

void* createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive*, std::size_t count,
                 void*) {
  auto* node = new (rtcThreadLocalAlloc(allocator, sizeof(TreeNode), 16)) TreeNode;
  node->triangles = static_cast<std::uint32_t>(count);
  return node;
}

void split(const RTCBuildPrimitive* primitive, unsigned axis, float position, RTCBounds* left,
           RTCBounds* right, void*) {
  for (RTCBounds* side : {left, right}) {
    *side = {primitive->lower_x, primitive->lower_y, primitive->lower_z, 0.0F,
             primitive->upper_x, primitive->upper_y, primitive->upper_z, 0.0F};
  }
  (&left->upper_x)[axis] = position;
  (&right->lower_x)[axis] = position;
}

}  // namespace

double sahCost(std::span<const CostItem> items) {
  double sum = 0.0;
  for (const CostItem& item : items) {
    const auto cost = static_cast<double>(item.triangles == 0 ? kNodeCost : kTriangleCost);
    sum += cost * std::max(item.triangles, 1U) * static_cast<double>(item.box.halfArea());
  }
  return sum / static_cast<double>(items.front().box.halfArea());
}

std::vector<CostItem> costItems(const Bvh& bvh) {
  std::vector<CostItem> items{{{}, 0}};
  for (const shared::Node& node : bvh.nodes)
    for (const shared::Child& child : node.child)
      if (child.ref != shared::REF_NONE) items.push_back({{child.lo, child.hi}, child.count});
  for (std::size_t i = 1; i < items.size(); ++i) items[0].box.grow(items[i].box);
  return items;
}

std::vector<CostItem> embreeTree(const EmbreeDevice& device, const EmbreeMesh& mesh,
                                 RTCBuildQuality quality) {
  std::vector<RTCBuildPrimitive> primitives;
  // HIGH quality may double the number of primitives by splitting.
  primitives.reserve(mesh.triangles.size() * 2);
  for (const glm::uvec3& t : mesh.triangles) {
    test::Box box;
    for (const std::uint32_t corner : {t.x, t.y, t.z}) box.grow(mesh.positions[corner]);
    primitives.push_back({box.lo.x, box.lo.y, box.lo.z, 0, box.hi.x, box.hi.y, box.hi.z,
                          static_cast<unsigned>(primitives.size())});
  }
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = quality;
  arguments.maxBranchingFactor = shared::NODE_WIDTH;
  arguments.maxDepth = 1024;
  arguments.maxLeafSize = shared::MAX_LEAF;
  arguments.traversalCost = kNodeCost;
  arguments.intersectionCost = kTriangleCost;
  arguments.bvh = rtcNewBVH(device.get());
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.capacity();
  arguments.createNode = createNode;
  arguments.setNodeChildren = setChildren;
  arguments.setNodeBounds = setBounds;
  arguments.createLeaf = createLeaf;
  arguments.splitPrimitive = split;

  std::vector<CostItem> items{{{}, 0}};
  std::vector<const TreeNode*> open{static_cast<const TreeNode*>(rtcBuildBVH(&arguments))};
  while (!open.empty()) {
    const TreeNode& node = *open.back();
    open.pop_back();
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const auto* child = static_cast<const TreeNode*>(node.child[i]);
      items.push_back({node.box[i], child->triangles});
      items[0].box.grow(node.box[i]);
      open.push_back(child);
    }
  }
  rtcReleaseBVH(arguments.bvh);
  return items;
}

}  // namespace laver::bench
