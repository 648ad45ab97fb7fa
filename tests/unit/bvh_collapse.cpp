#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "bvh/slots.h"
#include "bvh/wide.h"
#include "unit/bvh_soup.h"

namespace laver::test {
namespace {

using shared::Triangle;

TEST(WideTree, FourClustersFarApartAreLeavesOfOneNode) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 4 * shared::MAX_LEAF; ++i) {
    const float x = static_cast<float>(i % 4) * 10.0F, y = static_cast<float>(i) * 0.01F;
    triangles.push_back(triangle({x, y, 0}, {x + 1, 1, 0}, {x, 1, 1}, i));
  }
  const Bvh bvh = buildBvh(triangles, 1);
  EXPECT_EQ(bvh.nodes.size(), 1U);
  // One of the remaining slots divides a cluster.
  EXPECT_EQ(bvh.leaves, shared::NODE_WIDTH);
}

TEST(WideTree, OneBoxIsOneLeaf) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < shared::MAX_LEAF; ++i)
    triangles.push_back(triangle({0, 0, 0}, {1, 1, 0}, {0, 1, 1}, i));
  const Bvh bvh = buildBvh(triangles, 1);
  EXPECT_EQ(bvh.nodes.size(), 1U);
  EXPECT_EQ(bvh.leaves, 1U);
}

/// Minimum of cost times area of a subtree as at most `trees` wide trees, by plain recursion.
double minimumCost(const BinaryTree& tree, const Subtree& s, unsigned trees) {
  const double area = static_cast<double>(tree.box(s).halfArea());
  const double leaf = area * s.count * static_cast<double>(kTriangleCost);
  if (s.count == 1) return leaf;
  double minimum = std::numeric_limits<double>::infinity();
  const auto divided = [&](unsigned among, double more) {
    for (unsigned k = 1; k < among; ++k)
      minimum = std::min(minimum, more + minimumCost(tree, tree.left(s), k) +
                                      minimumCost(tree, tree.right(s), among - k));
  };
  if (s.count <= shared::MAX_LEAF) minimum = leaf;
  if (trees == 1) divided(shared::NODE_WIDTH, area * static_cast<double>(kNodeCost));
  for (unsigned fewer = 2; fewer <= trees; ++fewer) divided(fewer, 0.0);
  if (trees > 1) minimum = std::min(minimum, minimumCost(tree, s, 1));
  return minimum;
}

TEST(WideTree, CollapseReachesTheMinimumCost) {
  for (const std::uint32_t count : {2U, 3U, 5U, 9U, 13U}) {
    for (const float size : {0.05F, 0.8F}) {
      const auto triangles = randomTriangles(count, size);
      const BinaryTree tree = buildBinary(itemsOf(triangles), 1);
      const double area = static_cast<double>(tree.box(tree.root()).halfArea());
      const double leaf = static_cast<double>(kTriangleCost) * count;
      double minimum = minimumCost(tree, tree.root(), 1) / area;
      // A root that would best be a leaf becomes that leaf below a node.
      if (count <= shared::MAX_LEAF && minimum > leaf * (1.0 - 1e-6))
        minimum += static_cast<double>(kNodeCost);
      // Sums of about twenty floats of one sign, each rounded to 6e-8 of itself.
      EXPECT_NEAR(buildBvh(triangles, 1).sahCost, minimum, minimum * 2e-6);
    }
  }
}

TEST(BinaryTree, FourItemsAreDividedAtMinimumCost) {
  for (std::ptrdiff_t seed = 0; seed < 50; ++seed) {
    auto triangles = randomTriangles(200, 0.8F);
    triangles.erase(triangles.begin(), triangles.begin() + seed * 4);
    triangles.resize(4);
    const BinaryTree tree = buildBinary(itemsOf(triangles), 1);
    const auto cost = [&](unsigned side) {  // bit i: item i is on the left
      Box4 left = kEmptyBox, right = kEmptyBox;
      for (std::size_t i = 0; i < 4; ++i)
        ((side >> i & 1U) != 0 ? left : right).grow(tree.items[i].box);
      const auto lefts = static_cast<float>(std::popcount(side));
      return left.halfArea() * lefts + right.halfArea() * (4.0F - lefts);
    };
    float minimum = cost(1);
    for (unsigned side = 2; side < 15; ++side) minimum = std::min(minimum, cost(side));
    EXPECT_FLOAT_EQ(cost((1U << tree.nodes[0].leftCount) - 1), minimum);
  }
}

TEST(Slots, AChildLiesOnTheSidesOfItsSlot) {
  std::array<Box4, shared::NODE_WIDTH> boxes;
  for (unsigned i = 0; i < boxes.size(); ++i) {
    const unsigned slot = i * 3 % 8;
    const glm::vec3 at(slot & 1U, slot >> 1 & 1U, slot >> 2 & 1U);
    boxes[i] = BuildItem(at, at + 1.0F, 0).box;
  }
  const auto slotOf = assignSlots(BuildItem(glm::vec3(0), glm::vec3(2), 0).box, boxes);
  for (unsigned i = 0; i < boxes.size(); ++i) EXPECT_EQ(slotOf[i], i * 3 % 8);
}

TEST(Slots, CoincidentChildrenGetDifferentSlots) {
  const Box4 box = BuildItem(glm::vec3(0), glm::vec3(1), 0).box;
  const std::array<Box4, 5> boxes{box, box, box, box, box};
  const auto slotOf = assignSlots(box, boxes);
  EXPECT_EQ(std::set(slotOf.begin(), slotOf.begin() + 5).size(), 5U);
}

}  // namespace
}  // namespace laver::test
