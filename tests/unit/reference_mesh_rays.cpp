#include <gtest/gtest.h>

#include <cmath>

#include "reference/tree.h"
#include "support/bumpy_sphere.h"
#include "unit/reference_scenes.h"
#include "unit/reference_soup.h"

namespace laver::test {
namespace {

using namespace reference;

TEST(ReferenceMeshRays, ClosedMeshHasNoLeakFromInside) {
  const Mesh mesh = bumpySphere(24, 40, 0.1, glm::dvec3(0.0));
  const Tree tree(trianglesOf(mesh));
  Random random(4);
  int misses = 0;
  for (int i = 0; i < 60000; ++i) {
    const glm::uvec3 t = mesh.triangles[random.index(mesh.triangles.size())];
    const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y];
    const double along = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 0.5 : random.number(0, 1);
    const glm::dvec3 origin = random.point(0.2);
    misses += !tree.closest({origin, glm::mix(a, b, along) - origin}, 0.0, 1e20);
  }
  EXPECT_EQ(misses, 0);
}

TEST(ReferenceMeshRays, ClosedMeshHasNoLeakFromOutside) {
  const Mesh mesh = bumpySphere(24, 40, 0.1, glm::dvec3(0.0));
  const std::vector<Triangle> triangles = trianglesOf(mesh);
  const Tree tree(triangles);
  Random random(5);
  int aimed = 0, misses = 0;
  for (int i = 0; i < 60000; ++i) {
    const glm::uvec3 t = mesh.triangles[random.index(mesh.triangles.size())];
    const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y];
    const glm::dvec3 aim = i % 2 ? a : glm::mix(a, b, random.number(0, 1));
    const glm::dvec3 origin = random.point(i % 5 ? 4 : 400);
    // A line from outside that enters the sphere of radius 0.8 must have crossed the surface
    // before.
    const glm::dvec3 direction = glm::normalize(aim - origin);
    const double nearest = -glm::dot(origin, direction);
    const double inside = 0.64 - glm::dot(origin, origin) + nearest * nearest;
    if (glm::length(origin) < 2 || inside <= 0) continue;
    ++aimed;
    const auto hit = tree.closest({origin, direction}, 0.0, 1e20);
    misses += !hit || hit->t > nearest - std::sqrt(inside);
  }
  EXPECT_GT(aimed, 3000);
  EXPECT_EQ(misses, 0);
}

TEST(ReferenceMeshRays, SmallestNumberWinsAmongCopies) {
  const Mesh mesh = bumpySphere(12, 20, 0.1, glm::dvec3(0.0));
  std::vector<Triangle> triangles;
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t copy = 0; copy < 6; ++copy) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const glm::uvec3 t = mesh.triangles[i];
      const glm::dvec3 v[] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
      const auto turnedBy = [&](std::uint32_t k) { return v[(copy + k) % 3]; };
      const bool flipped = copy % 2 == 0;
      triangles.emplace_back(turnedBy(0), turnedBy(flipped ? 2 : 1), turnedBy(flipped ? 1 : 2),
                             (5 - copy) * count + i);
    }
  }
  const Tree tree(triangles);
  Random random(6);
  for (int i = 0; i < 5000; ++i) {
    const auto hit = tree.closest({random.point(0.2), random.point(1)}, 0.0, 1e20);
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->triangle->id, count);
  }
}

TEST(ReferenceMeshRays, ThreadsDoNotMatter) {
  Random random(7);
  const std::vector<Triangle> triangles = soup(random, 5000, 0.1);
  std::vector<Triangle> one = triangles, two = triangles;
  const std::vector<Node> nodesOne = buildTree(one, 1), nodesTwo = buildTree(two, 2);
  ASSERT_EQ(nodesOne.size(), nodesTwo.size());
  for (std::size_t i = 0; i < nodesOne.size(); ++i) {
    ASSERT_EQ(nodesOne[i].next, nodesTwo[i].next);
    ASSERT_EQ(nodesOne[i].count, nodesTwo[i].count);
  }
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(one[i].id, two[i].id);
}

TEST(ReferenceMeshRays, CascadesAndHeapsStayBounded) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 600; ++i) {
    const double size = std::pow(0.3, i % 300);
    triangles.emplace_back(glm::dvec3(size, 0, 0), glm::dvec3(0, size, 0), glm::dvec3(0, 0, size),
                           i);
  }
  for (std::uint32_t i = 600; i < 3000; ++i) {
    triangles.emplace_back(glm::dvec3(2, 0, 0), glm::dvec3(2, 1, 0), glm::dvec3(2, 0, 1), i);
  }
  const Tree tree(triangles);
  const auto hit = tree.closest({{5, 0.25, 0.25}, {-1, 0, 0}}, 0.0, 1e20);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle->id, 600u);
  EXPECT_TRUE(tree.closest({{1e-20, 1e-20, 1e-20}, {1, 1, 1}}, 0.0, 1e20));
}

}  // namespace
}  // namespace laver::test
