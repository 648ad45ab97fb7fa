#include "unit/bvh_soup.h"

namespace laver::test {
namespace {

TEST(Bvh, NoTrianglesAreANodeWithoutChildren) {
  const Bvh bvh = buildBvh({}, 1);
  EXPECT_EQ(bvh.root, 0U);
  ASSERT_EQ(bvh.nodes.size(), 1U);
  for (const auto& child : bvh.nodes[0].child) EXPECT_EQ(child.ref, shared::REF_NONE);
}

TEST(Bvh, OneTriangleIsALeafBelowTheRoot) {
  const auto triangles = randomTriangles(1, 0.1F);
  const Bvh bvh = buildBvh(triangles, 1);
  EXPECT_EQ(bvh.root, 0U);
  EXPECT_EQ(bvh.leaves, 1U);
  EXPECT_EQ(bvh.triangles.at(0).more, 0U);
  expectSound(triangles);
}

TEST(Bvh, RandomSoupIsSound) {
  for (const std::uint32_t count : {2U, 3U, 9U, 100U, 5000U})
    expectSound(randomTriangles(count, 0.1F));
  expectSound(randomTriangles(2000, 1.5F));
}

TEST(Bvh, TheTreeDoesNotDependOnThreads) {
  const auto triangles = randomTriangles(100000, 0.02F);
  const Bvh one = buildBvh(triangles, 1);
  EXPECT_TRUE(same(one, buildBvh(triangles, 2)));
  EXPECT_TRUE(same(one, buildBvh(triangles, 5)));
}

TEST(Bvh, SahCostBeatsMedianHalving) {
  // A sparse cloud and a dense cluster, for which halving by count is known to be poor.
  auto triangles = randomTriangles(2000, 0.01F);
  for (std::size_t i = 0; i < 1000; ++i) {
    triangles[i].a = triangles[i].a * 0.01F;
    triangles[i].b = triangles[i].b * 0.01F;
    triangles[i].c = triangles[i].c * 0.01F;
  }
  const Bvh bvh = buildBvh(triangles, 1);
  EXPECT_GT(bvh.sahCost, 1.0);
  EXPECT_LT(bvh.sahCost, 40.0);  // one flat list would cost 0.06 * 2000 = 120
}

}  // namespace
}  // namespace laver::test
