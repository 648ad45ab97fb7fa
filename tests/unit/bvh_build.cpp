#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <set>

#include "bvh/binary.h"
#include "bvh/bvh.h"
#include "bvh/wide.h"

namespace laver {
namespace {

using shared::Node;
using shared::Triangle;

Triangle triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, std::uint32_t id) {
  return {a, id, b, 0, c, 0};
}

std::vector<Triangle> randomTriangles(std::uint32_t count, float size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-1.0F, 1.0F), side(-size, size);
  const auto point = [&](auto& d) { return glm::vec3(d(random), d(random), d(random)); };
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 a = point(place);
    triangles.push_back(triangle(a, a + point(side), a + point(side), i));
  }
  return triangles;
}

bool holds(const shared::Child& child, glm::vec3 p) {
  return glm::all(glm::lessThan(child.lo, p)) && glm::all(glm::greaterThan(child.hi, p));
}

/// Walks the tree: every triangle lies strictly inside all boxes above it, each comes once, leaves
/// are no larger than the layout allows, and depth and stack are as stated.
class Walk {
 public:
  explicit Walk(const Bvh& bvh) : bvh_(bvh) {
    std::vector<shared::Child> above;
    visit(bvh.root, above, 0, 1);
  }
  std::multiset<std::uint32_t> ids;
  std::uint32_t depth = 0, stack = 0, nodes = 0;

 private:
  void visit(std::uint32_t ref, std::vector<shared::Child>& above, std::uint32_t level,
             std::uint32_t entries) {
    if (ref == shared::REF_NONE) return;
    if (ref >= shared::REF_LEAF) {
      EXPECT_EQ(ref >> shared::REF_KIND_SHIFT & 7U, shared::KIND_TRIANGLE);
      std::uint32_t slot = ref & shared::REF_INDEX_MASK, count = 0, more = 0;
      do {
        const Triangle& t = bvh_.triangles.at(slot);
        ids.insert(t.id);
        for (const auto& child : above)
          EXPECT_TRUE(holds(child, t.a) && holds(child, t.b) && holds(child, t.c));
        more = t.more;
        ++slot;
        ++count;
      } while (more != 0);
      EXPECT_LE(count, shared::MAX_LEAF);
      if (!above.empty()) {
        EXPECT_EQ(count, above.back().count);
      }
      return;
    }
    ++nodes;
    depth = std::max(depth, level + 1);
    const Node& node = bvh_.nodes.at(ref);
    std::uint32_t children = 0;
    for (const auto& child : node.child) children += child.ref == shared::REF_NONE ? 0 : 1;
    EXPECT_GE(children, 2U);
    stack = std::max(stack, entries + children - 1);
    for (const auto& child : node.child) {
      above.push_back(child);
      visit(child.ref, above, level + 1, entries + children - 1);
      above.pop_back();
    }
  }
  const Bvh& bvh_;
};

void expectSound(const std::vector<Triangle>& triangles) {
  const Bvh bvh = buildBvh(triangles, 2);
  const Walk walk(bvh);
  std::multiset<std::uint32_t> wanted;
  for (const auto& t : triangles) wanted.insert(t.id);
  EXPECT_EQ(walk.ids, wanted);
  EXPECT_EQ(walk.nodes, bvh.nodes.size());
  EXPECT_EQ(walk.depth, bvh.depth);
  EXPECT_LE(walk.stack, bvh.stack);
}

TEST(Bvh, NoTriangles) {
  const Bvh bvh = buildBvh({}, 1);
  EXPECT_EQ(bvh.root, shared::REF_NONE);
  EXPECT_TRUE(bvh.nodes.empty());
}

TEST(Bvh, OneTriangleIsALeafAtTheRoot) {
  const auto triangles = randomTriangles(1, 0.1F);
  const Bvh bvh = buildBvh(triangles, 1);
  EXPECT_EQ(bvh.root, shared::REF_LEAF);
  EXPECT_EQ(bvh.triangles.at(0).more, 0U);
  expectSound(triangles);
}

TEST(Bvh, RandomSoupIsSound) {
  for (const std::uint32_t count : {2U, 3U, 9U, 100U, 5000U})
    expectSound(randomTriangles(count, 0.1F));
  expectSound(randomTriangles(2000, 1.5F));
}

TEST(Bvh, EqualCentroidsAreHalved) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 1000; ++i)
    triangles.push_back(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, i));
  expectSound(triangles);
  EXPECT_LE(buildBvh(triangles, 1).depth, 10U);
}

TEST(Bvh, ExponentialSpacingIsBoundedInDepth) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 180; ++i) {
    const float s = std::pow(0.6F, static_cast<float>(i));
    triangles.push_back(triangle({s, s, s}, {s * 1.01F, s, s}, {s, s * 1.01F, s}, i));
  }
  expectSound(triangles);
  std::vector<BuildItem> items;
  for (const auto& t : triangles) {
    Box box;
    box.grow(t.a);
    box.grow(t.b);
    box.grow(t.c);
    items.push_back({box, t.id});
  }
  const auto nodes = buildBinary(items, 1);
  std::vector<std::uint32_t> depth(nodes.size(), 1);
  std::uint32_t deepest = 0;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    deepest = std::max(deepest, depth[i]);
    if (nodes[i].count == 1) continue;
    depth[nodes[i].left(i)] = depth[nodes[i].right] = depth[i] + 1;
  }
  EXPECT_LE(deepest, kSahDepth + 1 + 8);  // log2(180) < 8
}

TEST(Bvh, TheTreeDoesNotDependOnThreads) {
  const auto triangles = randomTriangles(100000, 0.02F);
  const Bvh one = buildBvh(triangles, 1), two = buildBvh(triangles, 2),
            five = buildBvh(triangles, 5);
  const auto same = [](const Bvh& a, const Bvh& b) {
    return a.nodes.size() == b.nodes.size() &&
           std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(Node)) == 0 &&
           std::memcmp(a.triangles.data(), b.triangles.data(),
                       a.triangles.size() * sizeof(Triangle)) == 0;
  };
  EXPECT_TRUE(same(one, two));
  // The number of ranges built side by side may differ, the splits may not.
  EXPECT_TRUE(same(one, five));
}

TEST(Bvh, SahCostBeatsMedianHalving) {
  // A sparse cloud and a dense cluster: halving by count is known to be poor there.
  auto triangles = randomTriangles(2000, 0.01F);
  for (std::size_t i = 0; i < 1000; ++i) {
    triangles[i].a = triangles[i].a * 0.01F;
    triangles[i].b = triangles[i].b * 0.01F;
    triangles[i].c = triangles[i].c * 0.01F;
  }
  const Bvh bvh = buildBvh(triangles, 1);
  EXPECT_GT(bvh.sahCost, 1.0);
  EXPECT_LT(bvh.sahCost, 40.0);  // one flat list would cost 0.3 * 2000 = 600
}

TEST(WideTree, CollapsedCostIsTheLeastOfSmallTrees) {
  // Four items far apart: one node of four leaves is cheaper than any tree of two levels.
  std::vector<BuildItem> items;
  for (std::uint32_t i = 0; i < 4; ++i) {
    Box box;
    box.grow(glm::vec3(static_cast<float>(i) * 10.0F, 0, 0));
    box.grow(glm::vec3(static_cast<float>(i) * 10.0F + 1.0F, 1, 1));
    items.push_back({box, i});
  }
  const auto nodes = buildBinary(items, 1);
  const auto wide = collapse(nodes, 8, 1);
  ASSERT_EQ(wide.size(), 1U);
  EXPECT_EQ(wide[0].children.size(), 4U);
  // Touching items of one box: a leaf is cheapest.
  for (auto& item : items) item.box = items[0].box;
  EXPECT_TRUE(collapse(buildBinary(items, 1), 8, 8).empty());
}

}  // namespace
}  // namespace laver
