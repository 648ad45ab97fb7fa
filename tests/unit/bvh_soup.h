// Triangles for trees, and checks of the trees' invariants.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <set>
#include <vector>

#include "bvh/binary.h"
#include "bvh/walk.h"

namespace laver::test {

inline shared::Triangle triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, std::uint32_t id) {
  return {a, id, b, 0, c, 0};
}

inline std::vector<shared::Triangle> randomTriangles(std::uint32_t count, float size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-1.0F, 1.0F), side(-size, size);
  const auto point = [&](auto& d) { return glm::vec3(d(random), d(random), d(random)); };
  std::vector<shared::Triangle> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 a = point(place);
    triangles.push_back(triangle(a, a + point(side), a + point(side), i));
  }
  return triangles;
}

inline bool holds(const shared::Child& child, glm::vec3 p) {
  return glm::all(glm::lessThan(child.lo, p)) && glm::all(glm::greaterThan(child.hi, p));
}

/// Walks the tree and checks that every triangle occurs once and lies strictly inside all boxes
/// above it, that leaves have at most MAX_LEAF triangles, and that depth and stack are as stated.
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
      std::uint32_t count = 0;
      forEachTriangle(bvh_, ref, [&](const shared::Triangle& t) {
        ids.insert(t.id);
        for (const auto& child : above)
          EXPECT_TRUE(holds(child, t.a) && holds(child, t.b) && holds(child, t.c));
        ++count;
      });
      EXPECT_EQ(count, (ref >> shared::REF_COUNT_SHIFT & 7U) + 1);
      if (!above.empty()) {
        EXPECT_EQ(count, above.back().count);
      }
      return;
    }
    ++nodes;
    depth = std::max(depth, level + 1);
    const shared::Node& node = bvh_.nodes.at(ref);
    std::uint32_t children = 0;
    for (const auto& child : node.child) children += child.ref == shared::REF_NONE ? 0 : 1;
    EXPECT_GE(children, above.empty() ? 1U : 2U);
    stack = std::max(stack, entries + children - 1);
    for (const auto& child : node.child) {
      above.push_back(child);
      visit(child.ref, above, level + 1, entries + children - 1);
      above.pop_back();
    }
  }
  const Bvh& bvh_;
};

inline void expectSound(const std::vector<shared::Triangle>& triangles) {
  const Bvh bvh = buildBvh(triangles, 2);
  const Walk walk(bvh);
  std::multiset<std::uint32_t> wanted;
  for (const auto& t : triangles) wanted.insert(t.id);
  EXPECT_EQ(walk.ids, wanted);
  EXPECT_EQ(walk.nodes, bvh.nodes.size());
  EXPECT_EQ(walk.depth, bvh.depth);
  EXPECT_LE(walk.stack, bvh.stack);
}

inline UninitialisedVector<BuildItem> itemsOf(const std::vector<shared::Triangle>& triangles) {
  UninitialisedVector<BuildItem> items;
  for (const shared::Triangle& t : triangles)
    items.emplace_back(glm::min(glm::min(t.a, t.b), t.c), glm::max(glm::max(t.a, t.b), t.c), t.id);
  return items;
}

inline unsigned depthOf(const BinaryTree& tree, const Subtree& s) {
  if (s.count == 1) return 1;
  return 1 + std::max(depthOf(tree, tree.left(s)), depthOf(tree, tree.right(s)));
}

inline bool same(const Bvh& a, const Bvh& b) {
  return a.nodes.size() == b.nodes.size() && a.triangles.size() == b.triangles.size() &&
         a.root == b.root && a.depth == b.depth && a.stack == b.stack &&
         std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(shared::Node)) == 0 &&
         std::memcmp(a.triangles.data(), b.triangles.data(),
                     a.triangles.size() * sizeof(shared::Triangle)) == 0;
}

}  // namespace laver::test
