#include "bvh/bvh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bvh/binary.h"
#include "bvh/wide.h"
#include "core/error.h"
#include "core/parallel.h"

namespace laver {
namespace {

using shared::Node;
using shared::NODE_WIDTH;
using shared::Triangle;

Box boxOf(const Triangle& t) {
  Box box;
  box.grow(t.a);
  box.grow(t.b);
  box.grow(t.c);
  return box;
}

/// Grows a box by 1 ulp and 1e-18 on each side, so that a reciprocal's rounding loses no ray.
Box padded(Box box) {
  for (int a = 0; a < 3; ++a) {
    box.lo[a] = std::nextafter(box.lo[a] - 1e-18F, -INFINITY);
    box.hi[a] = std::nextafter(box.hi[a] + 1e-18F, INFINITY);
  }
  return box;
}

/// Slots for children, so that visiting slot (turn ^ octant) at each turn goes front to back: a
/// child wants the slot whose bits tell on which sides of the node it lies. Greedy over all pairs
/// (Ylitie et al. 2017, section 3.2, solve the same assignment exactly).
std::array<int, NODE_WIDTH> assignSlots(const Box& box, std::span<const Box> children) {
  std::array<int, NODE_WIDTH> childOf;
  childOf.fill(-1);
  std::array<glm::vec3, NODE_WIDTH> offset;
  for (std::size_t c = 0; c < children.size(); ++c)
    offset[c] = (children[c].lo + children[c].hi) - (box.lo + box.hi);
  std::array<bool, NODE_WIDTH> placed{};
  for (std::size_t round = 0; round < children.size(); ++round) {
    float best = -INFINITY;
    std::size_t bestChild = 0, bestSlot = 0;
    for (std::size_t c = 0; c < children.size(); ++c) {
      if (placed[c]) continue;
      for (std::size_t s = 0; s < NODE_WIDTH; ++s) {
        if (childOf[s] >= 0) continue;
        const float score = ((s & 1U) != 0 ? offset[c].x : -offset[c].x) +
                            ((s & 2U) != 0 ? offset[c].y : -offset[c].y) +
                            ((s & 4U) != 0 ? offset[c].z : -offset[c].z);
        if (score > best) {
          best = score;
          bestChild = c;
          bestSlot = s;
        }
      }
    }
    childOf[bestSlot] = static_cast<int>(bestChild);
    placed[bestChild] = true;
  }
  return childOf;
}

/// Turns wide nodes into the device's layout.
class Flattener {
 public:
  Flattener(const std::vector<BinaryNode>& binary, const std::vector<WideNode>& wide,
            std::uint32_t leafMask)
      : binary_(binary), wide_(wide), leafMask_(leafMask), indexOf_(binary.size()) {
    for (std::uint32_t i = 0; i < wide.size(); ++i) indexOf_[wide[i].binary] = i;
  }

  std::vector<Node> nodes(unsigned threads) const {
    std::vector<Node> out(wide_.size());
    parallelFor(wide_.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) out[i] = flatten(wide_[i]);
    });
    return out;
  }

  std::uint32_t indexOf(std::uint32_t binary) const { return indexOf_[binary]; }

 private:
  Node flatten(const WideNode& node) const {
    std::array<Box, NODE_WIDTH> boxes;
    for (std::size_t c = 0; c < node.children.size(); ++c)
      boxes[c] = binary_[node.children[c].binary].box;
    const auto childOf =
        assignSlots(binary_[node.binary].box, std::span(boxes.data(), node.children.size()));
    Node out;
    for (std::size_t s = 0; s < NODE_WIDTH; ++s) {
      if (childOf[s] < 0) {
        out.child[s] = {glm::vec3(0.0F), shared::REF_NONE, glm::vec3(0.0F), 0};
        continue;
      }
      const auto c = static_cast<std::size_t>(childOf[s]);
      const Box box = padded(boxes[c]);
      const std::uint32_t child = node.children[c].binary;
      if (node.children[c].leaf)
        out.child[s] = {box.lo, leafMask_ | binary_[child].first, box.hi, binary_[child].count};
      else
        out.child[s] = {box.lo, indexOf_[child], box.hi, 0};
    }
    return out;
  }

  const std::vector<BinaryNode>& binary_;
  const std::vector<WideNode>& wide_;
  std::uint32_t leafMask_;
  std::vector<std::uint32_t> indexOf_;
};

/// Depth, worst case of the stack and SAH cost. Visiting a node pops one entry and pushes at most
/// its children, so the stack never holds more than 1 + the sum of (children - 1) along a path.
void measure(Bvh& bvh, const std::vector<BinaryNode>& binary, const std::vector<WideNode>& wide,
             const Flattener& flat) {
  const double rootArea = std::max<double>(static_cast<double>(binary[0].box.halfArea()), 1e-300);
  struct Path {
    std::uint32_t depth = 1, stack = 1;
  };
  std::vector<Path> paths(wide.size());
  for (std::size_t i = 0; i < wide.size(); ++i) {
    const WideNode& node = wide[i];
    Path below = paths[i];
    below.stack += static_cast<std::uint32_t>(node.children.size()) - 1;
    bvh.depth = std::max(bvh.depth, below.depth);
    bvh.stack = std::max(bvh.stack, below.stack);
    ++below.depth;
    bvh.sahCost += static_cast<double>(kNodeCost) *
                   static_cast<double>(binary[node.binary].box.halfArea()) / rootArea;
    for (const WideChild& child : node.children) {
      if (child.leaf) {
        const BinaryNode& leaf = binary[child.binary];
        bvh.sahCost += static_cast<double>(kTriangleCost) * leaf.count *
                       static_cast<double>(leaf.box.halfArea()) / rootArea;
        ++bvh.leaves;
      } else {
        paths[flat.indexOf(child.binary)] = below;
      }
    }
  }
}

}  // namespace

Bvh buildBvh(std::span<const Triangle> triangles, unsigned threads) {
  Bvh bvh;
  if (triangles.empty()) return bvh;
  // All ones in the index would be REF_NONE's.
  if (triangles.size() > shared::REF_INDEX_MASK)
    throw Error(ExitCode::Device, fmt::format("{} triangles; a tree holds at most {}",
                                              triangles.size(), shared::REF_INDEX_MASK));
  std::vector<BuildItem> items(triangles.size());
  parallelFor(items.size(), 1U << 15, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      items[i] = {boxOf(triangles[i]), static_cast<std::uint32_t>(i)};
  });
  const auto binary = buildBinary(items, threads);
  const auto wide = collapse(binary, NODE_WIDTH, shared::MAX_LEAF);
  const std::uint32_t leafMask = shared::REF_LEAF | shared::KIND_TRIANGLE << shared::REF_KIND_SHIFT;
  bvh.triangles.resize(triangles.size());
  parallelFor(items.size(), 1U << 15, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      bvh.triangles[i] = triangles[items[i].id];
      bvh.triangles[i].more = 0;
    }
  });
  const auto markLeaf = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) bvh.triangles[first + i].more = count - 1 - i;
  };
  if (wide.empty()) {
    bvh.root = leafMask;
    bvh.leaves = 1;
    bvh.sahCost = static_cast<double>(kTriangleCost) * static_cast<double>(triangles.size());
    markLeaf(0, static_cast<std::uint32_t>(triangles.size()));
    return bvh;
  }
  const Flattener flat(binary, wide, leafMask);
  bvh.nodes = flat.nodes(threads);
  bvh.root = 0;
  for (const WideNode& node : wide)
    for (const WideChild& child : node.children)
      if (child.leaf) markLeaf(binary[child.binary].first, binary[child.binary].count);
  measure(bvh, binary, wide, flat);
  return bvh;
}

}  // namespace laver
