#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reference/triangle.h"

namespace laver::test {
namespace {

using namespace reference;

__extension__ using Int128 = __int128;

int exactOrientation(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  const Int128 value = static_cast<Int128>(ax) * by - static_cast<Int128>(ay) * bx;
  return (value > 0) - (value < 0);
}

TEST(ReferenceTriangle, OrientationIsTheExactSign) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::int64_t> big(-(1ll << 52), 1ll << 52), small(-2, 2);
  int undecidedByRounding = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::int64_t ax = big(random), ay = big(random);
    // Nearly or exactly collinear: the difference of the products is far below their ulp.
    const std::int64_t bx = ax + small(random), by = ay + small(random);
    const glm::dvec3 a(ax, ay, 0), b(bx, by, 0);
    ASSERT_EQ(orientation(a, b), exactOrientation(ax, ay, bx, by));
    undecidedByRounding += a.x * b.y == a.y * b.x && exactOrientation(ax, ay, bx, by) != 0;
    const double value = area(a, b);
    ASSERT_EQ((value > 0) - (value < 0), orientation(a, b));
  }
  EXPECT_GT(undecidedByRounding, 1000);
}

TEST(ReferenceTriangle, CrossingOnAGridWithItsBorder) {
  std::mt19937 random(2);
  std::uniform_int_distribution<std::int64_t> place(-4, 4);
  const Shear shear({{0, 0, 10}, {0, 0, -1}});
  int hits = 0, border = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<std::array<std::int64_t, 3>, 3> v{};
    for (auto& corner : v) corner = {place(random), place(random), place(random)};
    const auto side = [&](std::size_t p, std::size_t q) {
      return exactOrientation(v[p][0], v[p][1], v[q][0], v[q][1]);
    };
    const int u = side(1, 2), w = side(2, 0), x = side(0, 1);
    const bool flat = u == 0 && w == 0 && x == 0;
    const bool expected = !flat && ((u >= 0 && w >= 0 && x >= 0) || (u <= 0 && w <= 0 && x <= 0));
    const auto corner = [&](std::size_t p) { return glm::dvec3(v[p][0], v[p][1], v[p][2]); };
    const Triangle triangle(corner(0), corner(1), corner(2), 0);
    const auto found = crossing(triangle, shear);
    ASSERT_EQ(found.has_value(), expected);
    hits += expected;
    border += expected && (u == 0 || w == 0 || x == 0);
    if (!found) continue;
    glm::dvec3 point(0.0);
    for (std::size_t k = 0; k < 3; ++k) point += found->weights[k] * triangle.corner[k];
    EXPECT_NEAR(point.x, 0, 1e-14);
    EXPECT_NEAR(point.y, 0, 1e-14);
    EXPECT_NEAR(10 - found->t, point.z, 1e-14);
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(border, 300);
}

TEST(ReferenceTriangle, EdgeOnIsNoHit) {
  const Triangle triangle({0, -1, 0}, {0, 1, 0}, {0, 0, 5}, 0);
  EXPECT_FALSE(crossing(triangle, Shear({{0, 0, 10}, {0, 0, -1}})));
  EXPECT_TRUE(crossing(triangle, Shear({{3, 0, 1}, {-1, 0, 0}})));
}

TEST(ReferenceTriangle, CopiesWithOtherCornersComputeTheSameBits) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::array<glm::dvec3, 3> v{point(), point(), point()};
    const glm::dvec3 origin = 3.0 * point();
    const Ray ray{origin, (v[0] + v[1] + v[2]) / 3.0 + 0.3 * point() - origin};
    std::array<std::size_t, 3> order{0, 1, 2};
    const Triangle first(v[0], v[1], v[2], 0);
    const auto expected = crossing(first, Shear(ray));
    if (!expected) continue;
    ++hits;
    const Weights weights = first.asGiven(expected->weights);
    while (std::next_permutation(order.begin(), order.end())) {
      const Triangle copy(v[order[0]], v[order[1]], v[order[2]], 0);
      const auto found = crossing(copy, Shear(ray));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->t, expected->t);
      EXPECT_EQ(planeT(copy, ray, 0), planeT(first, ray, 0));
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(copy.asGiven(found->weights)[k], weights[order[k]]);
      }
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(ReferenceTriangle, PlaneDistanceOfASliver) {
  // Slivers in the plane x + y + z = 3, where t = (3 - sum of origin) / sum of direction.
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Triangle sliver({-1023, 1025, 1}, {1025, -1023, 1}, {1, 1 + 0x1p-10, 1 - 0x1p-10}, 0);
  double worstCrossing = 0, worstPlane = 0;
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const double along = 800 * unit(random);
    const Ray ray{{5, -3, 11}, glm::dvec3(along - 4, 4 - along, 0x1p-11 * unit(random) - 10)};
    const auto found = crossing(sliver, Shear(ray));
    if (!found) continue;
    ++hits;
    const LongVec d(ray.direction);
    const auto truth = static_cast<double>(-10 / (d.x + d.y + d.z));
    worstCrossing = std::max(worstCrossing, std::abs(found->t / truth - 1));
    worstPlane = std::max(worstPlane, std::abs(planeT(sliver, ray, found->t) / truth - 1));
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(worstCrossing, 4e-15);
  EXPECT_LT(worstPlane, 3e-16);
}

TEST(ReferenceTriangle, SeparatesStrictly) {
  const Triangle triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
  EXPECT_TRUE(separates(triangle, {0, 0, 1e-300}, {5, 5, -1}));
  EXPECT_TRUE(separates(triangle, {5, 5, -1}, {0, 0, 1e-300}));
  EXPECT_FALSE(separates(triangle, {0, 0, 1}, {0, 0, 2}));
  EXPECT_FALSE(separates(triangle, {0, 0, 0}, {0, 0, 2}));
  EXPECT_FALSE(separates(triangle, {0, 0, -2}, {0, 0, 0}));
}

}  // namespace
}  // namespace laver::test
