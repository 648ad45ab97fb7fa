// Walks of the tree on the host.
#include <gtest/gtest.h>

#include <algorithm>

#include "bvh/walk.h"
#include "unit/bvh_soup.h"

namespace laver::test {
namespace {

const auto kAll = [](const shared::Child&) { return true; };

TEST(BvhWalk, VisitsEachTriangleOnceInAnyOrder) {
  const Bvh bvh = buildBvh(randomTriangles(500, 0.1F), 1);
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    std::vector<std::uint32_t> ids;
    EXPECT_FALSE(walk(bvh, octant, kAll, [&](const shared::Triangle& t) {
      ids.push_back(t.id);
      return false;
    }));
    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(ids.size(), 500U);
    for (std::uint32_t i = 0; i < 500; ++i) ASSERT_EQ(ids[i], i);
  }
}

TEST(BvhWalk, SkipsChildrenThatAreNotEntered) {
  const Bvh bvh = buildBvh(randomTriangles(500, 0.1F), 1);
  const glm::vec3 point(0.3F, -0.2F, 0.5F);
  std::size_t visited = 0;
  walk(
      bvh, 0, [&](const shared::Child& child) { return holds(child, point); },
      [&](const shared::Triangle&) {
        ++visited;
        return false;
      });
  EXPECT_LT(visited, 100U);
}

TEST(BvhWalk, StopsWhenAVisitReturnsTrue) {
  const Bvh bvh = buildBvh(randomTriangles(500, 0.1F), 1);
  std::size_t visited = 0;
  EXPECT_TRUE(walk(bvh, 0, kAll, [&](const shared::Triangle&) { return ++visited == 7; }));
  EXPECT_EQ(visited, 7U);
}

}  // namespace
}  // namespace laver::test
