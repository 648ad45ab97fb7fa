// Triangulation of polygons: coverage compared with winding numbers.
#include "scene/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace laver::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using Triangles = std::vector<glm::uvec3>;

double area(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Winding number of the outline around a point.
int winding(const std::vector<dvec2>& outline, const dvec2& q) {
  int turns = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y <= q.y) == (b.y <= q.y)) continue;
    if (a.y <= q.y && area(a, b, q) > 0.0) ++turns;
    if (b.y <= q.y && area(a, b, q) < 0.0) --turns;
  }
  return turns;
}

std::vector<dvec3> flat(const std::vector<dvec2>& outline) {
  std::vector<dvec3> corners;
  for (const dvec2& p : outline) corners.emplace_back(p, 0.0);
  return corners;
}

// How many of `points` random points in [0, side]^2 are covered by a number of triangles other than
// their winding number.
int wronglyCovered(const std::vector<dvec2>& outline, const Triangles& triangles, double side,
                   std::mt19937& random) {
  std::uniform_real_distribution<double> place(0.0, side);
  int wrong = 0;
  for (int i = 0; i < 200; ++i) {
    const dvec2 q(place(random), place(random));
    int covered = 0;
    for (const glm::uvec3& t : triangles)
      covered += winding({outline[t.x], outline[t.y], outline[t.z]}, q);
    wrong += covered != winding(outline, q);
  }
  return wrong;
}

// A simple polygon through random points: crossings are removed by 2-opt.
std::vector<dvec2> randomOutline(std::mt19937& random, bool onGrid) {
  std::uniform_real_distribution<double> place(0.0, 12.0);
  std::vector<dvec2> p(5 + random() % 30);
  for (dvec2& q : p) {
    q = dvec2(place(random), place(random));
    if (onGrid) q = glm::floor(q);
  }
  const auto shorten = [&] {
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = i + 2; j < p.size(); ++j) {
        const dvec2 &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % p.size()];
        if (glm::length(a - c) + glm::length(b - d) <
            glm::length(a - b) + glm::length(c - d) - 1e-9) {
          std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          return true;
        }
      }
    return false;
  };
  while (shorten()) {
  }
  return p;
}

// Grids create corners that touch edges and other corners; the extreme scales would overflow and
// underflow.
TEST(Polygon, RandomOutlinesAreCoveredOnceInAnyPlaneAndScale) {
  std::mt19937 random(1);
  for (int i = 0; i < 400; ++i) {
    const std::vector<dvec2> outline = randomOutline(random, i % 2 == 0);
    const double scale = i % 3 == 0 ? 1e200 : i % 3 == 1 ? 1e-200 : 1.0;
    std::vector<dvec3> corners;
    for (const dvec2& p : outline) corners.push_back(scale * dvec3(p.x, p.y * .6, p.y * .8));
    const obj::Triangulation cut = obj::triangulate(corners);
    ASSERT_EQ(cut.triangles.size(), outline.size() - 2);
    ASSERT_FALSE(cut.crossesItself) << i;
    ASSERT_EQ(wronglyCovered(outline, cut.triangles, 12.0, random), 0) << i;
  }
}

TEST(Polygon, ConvexOnesAreFans) {
  for (const double turn : {1.0, -1.0}) {
    std::vector<dvec2> disc;
    for (int i = 0; i < 100; ++i) {
      const double angle = turn * 2.0 * std::numbers::pi * i / 100.0;
      disc.emplace_back(std::cos(angle), std::sin(angle));
    }
    disc.insert(disc.begin() + 50, (disc[49] + disc[50]) / 2.0);  // straight
    const auto cut = obj::triangulate(flat(disc));
    EXPECT_FALSE(cut.crossesItself);
    for (unsigned i = 0; i < cut.triangles.size(); ++i)
      EXPECT_EQ(cut.triangles[i], glm::uvec3(0, i + 1, i + 2));
  }
}

TEST(Polygon, SlitsLeadToHoles) {
  const std::vector<dvec2> frame = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                                    {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  const auto cut = obj::triangulate(flat(frame));
  EXPECT_FALSE(cut.crossesItself);
  std::mt19937 random(2);
  EXPECT_EQ(wronglyCovered(frame, cut.triangles, 4.0, random), 0);
}

TEST(Polygon, CrossingOutlinesAreFound) {
  const std::vector<dvec2> star = {{0, 1}, {-.6, -.8}, {.95, .3}, {-.95, .3}, {.6, -.8}};
  const auto cut = obj::triangulate(flat(star));
  EXPECT_TRUE(cut.crossesItself);
  EXPECT_EQ(cut.triangles.size(), 3u);
  // A figure eight has no area, so its normal defines no plane.
  std::vector<dvec3> eight;
  for (const dvec2& p : {dvec2(0, 0), {1, 1}, {2, 0}, {2, 1}, {1, 0}, {0, 1}})
    eight.emplace_back(p.x, 7.0, p.y);
  EXPECT_TRUE(obj::triangulate(eight).crossesItself);
}

TEST(Polygon, OutlinesWithoutAreaAreCutToo) {
  EXPECT_EQ(obj::triangulate(std::vector<dvec3>(7, dvec3(1.0))).triangles.size(), 5u);
  EXPECT_EQ(obj::triangulate(flat({{0, 0}, {3, 3}, {1, 1}, {2, 2}, {4, 4}})).triangles.size(), 3u);
}

// A comb: half of the corners are reflex, few of them near any one ear.
TEST(Polygon, LargeOutlinesAreCutFast) {
  constexpr int kTeeth = 50000;
  std::vector<dvec2> comb = {{kTeeth, -1}, {kTeeth, 1}};
  for (int i = kTeeth - 1; i > 0; --i) {
    comb.emplace_back(i + .5, 0.0);
    comb.emplace_back(i, 1.0);
  }
  comb.emplace_back(0, -1);
  const auto cut = obj::triangulate(flat(comb));
  EXPECT_FALSE(cut.crossesItself);
  double sum = 0.0;
  for (const glm::uvec3& t : cut.triangles) {
    const double twice = area(comb[t.x], comb[t.y], comb[t.z]);
    ASSERT_GE(twice, 0.0);
    sum += twice / 2.0;
  }
  double expected = 0.0;
  for (std::size_t i = 1; i + 1 < comb.size(); ++i)
    expected += area(comb[0], comb[i], comb[i + 1]) / 2.0;
  EXPECT_NEAR(sum, expected, 1e-9 * expected);  // rounding of 1e5 sums
}

}  // namespace
}  // namespace laver::test
