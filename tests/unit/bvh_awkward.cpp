#include <bit>
#include <cmath>

#include "unit/bvh_soup.h"

namespace laver::test {
namespace {

using shared::Triangle;

TEST(BvhAwkward, EqualCentroidsAreHalved) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 1000; ++i)
    triangles.push_back(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, i));
  expectSound(triangles);
  EXPECT_LE(buildBvh(triangles, 1).depth, 10U);
}

TEST(BvhAwkward, ExponentialSpacingIsBoundedInDepth) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 180; ++i) {
    const float s = std::pow(0.6F, static_cast<float>(i));
    triangles.push_back(triangle({s, s, s}, {s * 1.01F, s, s}, {s, s * 1.01F, s}, i));
  }
  expectSound(triangles);
  const BinaryTree tree = buildBinary(itemsOf(triangles), 1);
  EXPECT_LE(depthOf(tree, tree.root()), kSahDepth + 1 + 8);  // log2(180) < 8
}

/// Large enough that several threads share the first splits.
constexpr std::uint32_t kAwkward = 40000;

/// Expects a sound tree, the same for any number of threads, within the depth bound.
void expectHandled(const std::vector<Triangle>& triangles) {
  expectSound(triangles);
  const Bvh one = buildBvh(triangles, 1);
  EXPECT_TRUE(same(one, buildBvh(triangles, 2)));
  const Bvh three = buildBvh(triangles, 3);
  EXPECT_TRUE(same(one, three));
  EXPECT_EQ(one.sahCost, three.sahCost);
  EXPECT_LE(one.depth, kSahDepth + static_cast<unsigned>(std::bit_width(triangles.size())));
  EXPECT_LE(one.stack, 1 + one.depth * (shared::NODE_WIDTH - 1));
}

TEST(BvhAwkward, OneCentroid) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> side(0.0F, 1.0F);
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < kAwkward; ++i) {
    const glm::vec3 d(side(random), side(random), side(random));
    triangles.push_back(triangle(d, -d, {d.x, -d.y, d.z}, i));
  }
  expectHandled(triangles);
}

TEST(BvhAwkward, Copies) {
  auto triangles = randomTriangles(kAwkward, 0.1F);
  for (std::uint32_t i = 0; i < kAwkward; ++i) {
    const std::uint32_t id = triangles[i].id;
    triangles[i] = triangles[i % 9];
    triangles[i].id = id;
  }
  expectHandled(triangles);
}

TEST(BvhAwkward, ExtremeAspect) {
  auto triangles = randomTriangles(kAwkward, 0.01F);
  for (auto& t : triangles)
    for (glm::vec3* p : {&t.a, &t.b, &t.c}) *p = *p * glm::vec3(1e-20F, 1.0F, 1e15F);
  expectHandled(triangles);
}

TEST(BvhAwkward, FlatAlongAnAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    auto triangles = randomTriangles(kAwkward, 0.01F);
    for (auto& t : triangles) t.a[axis] = t.b[axis] = t.c[axis] = 0.25F;
    expectHandled(triangles);
  }
}

TEST(BvhAwkward, ClustersFarApart) {
  auto triangles = randomTriangles(kAwkward, 0.01F);
  for (std::uint32_t i = 0; i < kAwkward; i += 3)
    for (glm::vec3* p : {&triangles[i].a, &triangles[i].b, &triangles[i].c})
      *p = *p * 1e-6F + glm::vec3(1e6F);
  expectHandled(triangles);
}

TEST(BvhAwkward, SpacedByPowersOfTwo) {
  // Each split separates few triangles, until the depth at which ranges are halved.
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < kAwkward; ++i) {
    const float s = std::ldexp(1.0F + static_cast<float>(i % 7) / 64.0F, -static_cast<int>(i % 97));
    triangles.push_back(triangle({s, s, s}, {s * 1.01F, s, s}, {s, s * 1.01F, s}, i));
  }
  expectHandled(triangles);
}

TEST(BvhAwkward, OutliersAtGrowingDistances) {
  // Each split separates some outliers, so that the range of all others is still large where ranges
  // are halved.
  auto triangles = randomTriangles(kAwkward, 0.01F);
  for (auto& t : triangles)
    for (glm::vec3* p : {&t.a, &t.b, &t.c}) *p *= 0x1p-80F;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 105; ++i) {
      Triangle& t = triangles[static_cast<std::size_t>(105 * axis + i)];
      const float shift = std::ldexp(1.0F, i - 65);
      for (glm::vec3* p : {&t.a, &t.b, &t.c}) (*p)[axis] += shift;
    }
  expectHandled(triangles);
}

TEST(BvhAwkward, LargestFloats) {
  // Sums of corners and areas overflow: the tree may be poor but must be valid.
  auto triangles = randomTriangles(kAwkward, 0.1F);
  for (auto& t : triangles)
    for (glm::vec3* p : {&t.a, &t.b, &t.c}) *p = *p * 2e38F;
  expectSound(triangles);
  EXPECT_TRUE(same(buildBvh(triangles, 1), buildBvh(triangles, 3)));
}

}  // namespace
}  // namespace laver::test
