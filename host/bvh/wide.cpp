#include "bvh/wide.h"

#include <array>
#include <limits>

namespace laver {
namespace {

constexpr unsigned kMaxWidth = 8;

/// Least cost of a subtree as a forest of at most i + 1 trees, and how it is reached.
struct Choice {
  std::array<float, kMaxWidth> cost;
  /// For i > 0: trees given to the left child, or 0 for the forest of one tree fewer. For i = 0:
  /// trees that the left child gets below a node of its own, or 0 for a leaf.
  std::array<std::uint8_t, kMaxWidth> left;
};

std::vector<Choice> choose(const std::vector<BinaryNode>& nodes, unsigned width, unsigned maxLeaf) {
  std::vector<Choice> choices(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 0;) {
    const BinaryNode& node = nodes[n];
    Choice& choice = choices[n];
    const float area = node.box.halfArea();
    const float leafCost = node.count <= maxLeaf
                               ? area * static_cast<float>(node.count) * kTriangleCost
                               : std::numeric_limits<float>::infinity();
    if (node.count == 1) {
      choice.cost.fill(leafCost);
      choice.left.fill(0);
      continue;
    }
    const Choice& l = choices[node.left(static_cast<std::uint32_t>(n))];
    const Choice& r = choices[node.right];
    // Best way to divide `trees` between the children.
    const auto divide = [&](unsigned trees, std::uint8_t& left) {
      float best = std::numeric_limits<float>::infinity();
      for (unsigned k = 1; k < trees; ++k) {
        const float cost = l.cost[k - 1] + r.cost[trees - k - 1];
        if (cost < best) {
          best = cost;
          left = static_cast<std::uint8_t>(k);
        }
      }
      return best;
    };
    std::uint8_t left = 1;
    const float inner = divide(width, left) + area * kNodeCost;
    choice.cost[0] = inner < leafCost ? inner : leafCost;
    choice.left[0] = inner < leafCost ? left : std::uint8_t{0};
    for (unsigned trees = 2; trees <= width; ++trees) {
      const float cost = divide(trees, left);
      const bool fewer = choice.cost[trees - 2] <= cost;
      choice.cost[trees - 1] = fewer ? choice.cost[trees - 2] : cost;
      choice.left[trees - 1] = fewer ? std::uint8_t{0} : left;
    }
  }
  return choices;
}

}  // namespace

std::vector<WideNode> collapse(const std::vector<BinaryNode>& nodes, unsigned width,
                               unsigned maxLeaf) {
  if (nodes.empty()) return {};
  const auto choices = choose(nodes, width, maxLeaf);
  if (choices[0].left[0] == 0) return {};

  std::vector<WideNode> wide;
  std::vector<std::uint32_t> open{0};
  std::vector<std::pair<std::uint32_t, unsigned>> forest;
  while (!open.empty()) {
    const std::uint32_t self = open.back();
    open.pop_back();
    WideNode node{self, {}};
    const unsigned left = choices[self].left[0];
    forest = {{nodes[self].right, width - left}, {nodes[self].left(self), left}};
    while (!forest.empty()) {
      auto [n, trees] = forest.back();
      forest.pop_back();
      while (trees > 1 && choices[n].left[trees - 1] == 0) --trees;
      if (trees == 1) {
        node.children.push_back({n, choices[n].left[0] == 0});
        continue;
      }
      const unsigned k = choices[n].left[trees - 1];
      forest.emplace_back(nodes[n].right, trees - k);
      forest.emplace_back(nodes[n].left(n), k);
    }
    for (std::size_t c = node.children.size(); c-- > 0;)
      if (!node.children[c].leaf) open.push_back(node.children[c].binary);
    wide.push_back(std::move(node));
  }
  return wide;
}

}  // namespace laver
