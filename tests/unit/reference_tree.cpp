#include <gtest/gtest.h>

#include <cmath>

#include "reference/tree.h"
#include "unit/reference_soup.h"

namespace laver::test {
namespace {

using namespace reference;

// The result of a loop over all triangles: the nearest hit by an independent formula, and how clear
// it is (the smallest weight or distance in t whose change could alter the result).
struct Loop {
  int id = -1;
  long double t = 1e30L, margin = 1.0L;
};

Loop loop(const std::vector<Triangle>& triangles, const Ray& ray) {
  Loop best;
  for (const Triangle& triangle : triangles) {
    const LongVec o(ray.origin), d(ray.direction), a(triangle.corner[0]);
    const LongVec e1 = LongVec(triangle.corner[1]) - a, e2 = LongVec(triangle.corner[2]) - a;
    const LongVec p = glm::cross(d, e2), s = o - a, q = glm::cross(s, e1);
    const long double determinant = glm::dot(e1, p);
    const long double u = glm::dot(s, p) / determinant, v = glm::dot(d, q) / determinant;
    const long double t = glm::dot(e2, q) / determinant;
    const long double inside = std::min({u, v, 1 - u - v});
    if (t > 0) best.margin = std::min(best.margin, std::abs(inside));
    if (inside < 0 || t < 0) continue;
    best.margin = std::min(best.margin, std::abs(t - best.t));
    if (t < best.t) {
      best.t = t;
      best.id = static_cast<int>(triangle.id);
    }
  }
  return best;
}

TEST(ReferenceTree, FindsWhatALoopFinds) {
  Random random(1);
  int hits = 0, decided = 0;
  for (const unsigned count : {1u, 2u, 5u, 17u, 100u, 700u}) {
    const std::vector<Triangle> triangles = soup(random, count, count < 50 ? 1.0 : 0.3);
    const Tree tree(triangles);
    for (int i = 0; i < 1500; ++i) {
      const glm::dvec3 origin = random.point(2);
      const Ray ray{origin, random.point(1) - origin};
      const auto found = tree.closest(ray, 0.0, 1e20);
      const Loop expected = loop(triangles, ray);
      if (expected.margin < 1e-9L) continue;
      ++decided;
      ASSERT_EQ(found ? static_cast<int>(found->triangle->id) : -1, expected.id);
      if (!found) continue;
      ++hits;
      EXPECT_NEAR(found->t, static_cast<double>(expected.t), 1e-9 * found->t);
    }
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(decided, 8900);
}

// The same as a loop with the tree's own triangle test: nothing is pruned by mistake. The loop goes
// by t, which is rounded; where the tree answers with another triangle, that one is nearer in exact
// arithmetic, or as near with a smaller number.
void expectSameAsEveryTriangle(const Tree& tree, const std::vector<Triangle>& triangles,
                               const Ray& ray, double tmin, double tmax) {
  const Triangle* best = nullptr;
  double t = tmax;
  for (const Triangle& triangle : triangles) {
    const auto found = crossing(triangle, Shear(ray));
    if (!found || found->t < tmin || found->t > t || (best && found->t == t)) continue;
    best = &triangle;
    t = found->t;
  }
  const auto hit = tree.closest(ray, tmin, tmax);
  ASSERT_EQ(hit.has_value(), best != nullptr);
  if (!best) return;
  if (hit->triangle->id != best->id) {
    const int order = reference::compareDepths({glm::dvec3(0.0), ray.origin, ray.direction},
                                               hit->triangle->corner, best->corner);
    EXPECT_TRUE(order < 0 || (order == 0 && hit->triangle->id < best->id));
  }
  EXPECT_NEAR(hit->t, t, 1e-9 * std::abs(t));
}

TEST(ReferenceTree, LosesNoHitOfABoxTest) {
  // Corners, edges and faces of boxes: flat triangles on a grid, rays from and along grid planes.
  Random random(2);
  std::vector<Triangle> triangles;
  const auto grid = [&] { return static_cast<double>(random.index(5)) - 2; };
  for (std::uint32_t i = 0; i < 300; ++i) {
    const glm::dvec3 a(grid(), grid(), grid());
    triangles.emplace_back(a, a + glm::dvec3(1, 0, 0), a + glm::dvec3(0, grid(), 1), i);
  }
  const Tree tree(triangles);
  for (int i = 0; i < 20000; ++i) {
    Ray ray{{grid(), grid(), grid()}, {0, 0, 0}};
    for (int k = 0; k < 3; ++k) {
      const double choices[] = {0.0, -0.0, 1.0, -1.0, 0.5, 1e-300, -1e-20};
      ray.direction[k] = choices[random.index(7)];
    }
    if (glm::abs(ray.direction) == glm::dvec3(0.0)) continue;
    expectSameAsEveryTriangle(tree, triangles, ray, i % 2 ? 0.0 : -5.0, i % 3 ? 100.0 : 1.0);
  }
}

TEST(ReferenceTree, LosesNoHitFarAway) {
  Random random(3);
  const std::vector<Triangle> triangles = soup(random, 300, 0.3);
  const Tree tree(triangles);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 aim = triangles[random.index(triangles.size())].corner[random.index(3)];
    const glm::dvec3 origin = random.point(std::pow(10.0, random.number(0, 12)));
    expectSameAsEveryTriangle(tree, triangles, {origin, aim - origin}, 0.0, 1e20);
  }
}

TEST(ReferenceTree, RangeIncludesItsEnds) {
  const Tree tree({Triangle({-1, -1, 2}, {1, -1, 2}, {0, 1, 2}, 0)});
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  EXPECT_TRUE(tree.closest(ray, 2.0, 2.0));
  EXPECT_FALSE(tree.closest(ray, 2.0 + 1e-15, 3.0));
  EXPECT_FALSE(tree.closest(ray, 0.0, 2.0 - 1e-15));
}

TEST(ReferenceTree, RangeOfOnlyTheHitsOwnTHoldsIt) {
  Random random(9);
  const std::vector<Triangle> triangles = soup(random, 200, 1e-3);
  const Tree tree(triangles);
  for (int i = 0; i < 20000; ++i) {
    const Triangle& triangle = triangles[random.index(triangles.size())];
    const glm::dvec3 origin = random.point(1000);
    const Ray ray{origin, triangle.corner[random.index(3)] - origin};
    const auto found = crossing(triangle, Shear(ray));
    if (!found) continue;
    ASSERT_TRUE(tree.closest(ray, found->t, found->t));
  }
}

TEST(ReferenceTree, EmptyTreeHasNoHit) {
  const Tree tree({});
  EXPECT_FALSE(tree.closest({{0, 0, 0}, {0, 0, 1}}, 0.0, 1e20));
  EXPECT_FALSE(tree.blocked({0, 0, 0}, {0, 0, 1}));
}

TEST(ReferenceTree, BlockedEqualsALoop) {
  Random random(8);
  const std::vector<Triangle> triangles = soup(random, 60, 0.5);
  const Tree tree(triangles);
  int blocked = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 from = random.point(1.2), to = random.point(i % 2 ? 1.2 : 1000);
    bool expected = false, clear = true;
    for (const Triangle& triangle : triangles) {
      const Loop one = loop({triangle}, {from, to - from});
      if (one.margin < 1e-9L || std::abs(one.t - 1) < 1e-9L || one.t < 1e-9L) clear = false;
      expected = expected || (one.id >= 0 && one.t < 1);
    }
    if (!clear) continue;
    blocked += expected;
    ASSERT_EQ(tree.blocked(from, to), expected);
  }
  EXPECT_GT(blocked, 500);
}

}  // namespace
}  // namespace laver::test
