// Scenes that cause deep trees or coincident leaves: the depth is bounded, the stack is sufficient,
// no loop limit is reached, and every hit equals that of a loop over all triangles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bvh/binary.h"
#include "pictures/harness.h"
#include "stability/meshes.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

struct Case {
  const char* name;
  std::vector<shared::Triangle> triangles;
};

/// Packed triangles: sorted corners, ids in order.
std::vector<shared::Triangle> packed(std::vector<glm::vec3> positions,
                                     const std::vector<glm::uvec3>& triangles) {
  const auto sorted = closedMesh(std::move(positions), triangles).bvh.triangles;
  return {sorted.begin(), sorted.end()};
}

std::vector<Case> scenes() {
  std::vector<Case> all;
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.emplace_back(first, first + 1, first + 2);
  };
  float size = 1.0F;
  for (int k = 0; k < 70; ++k, size *= 0.3F)
    add({-size, -size, -size}, {size, -size, -size}, {0.0F, size, -size});
  all.push_back({"cascade of 0.3^k", packed(positions, triangles)});
  positions.clear();
  triangles.clear();
  // A packet of incoherent rays visits all of these once per ray, within the driver's loop limit.
  for (int k = 0; k < 1500; ++k) add({-1, -1, -0.5F}, {1, -1, -0.5F}, {0, 1, -0.4F});
  all.push_back({"1,500 copies", packed(positions, triangles)});
  positions.clear();
  triangles.clear();
  for (int shell = 1; shell <= 40; ++shell) {
    const Mesh sphere = bumpySphere(10, 12, 0.0, glm::dvec3(0.0));
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const glm::dvec3& p : sphere.positions) positions.emplace_back(p * (shell / 41.0));
    for (const glm::uvec3& t : sphere.triangles) triangles.push_back(t + first);
  }
  all.push_back({"40 shells", packed(positions, triangles)});
  return all;
}

std::uint32_t depthOf(const BinaryTree& tree, const Subtree& s) {
  if (s.count == 1) return 1;
  return 1 + std::max(depthOf(tree, tree.left(s)), depthOf(tree, tree.right(s)));
}

LAVER_STABILITY(Trees, "Trees: cascade, duplicates, shells") {
  for (Case& c : scenes()) {
    UninitialisedVector<BuildItem> items;
    for (const shared::Triangle& t : c.triangles)
      items.emplace_back(glm::min(t.a, glm::min(t.b, t.c)), glm::max(t.a, glm::max(t.b, t.c)),
                         static_cast<std::uint32_t>(items.size()));
    const BinaryTree binary = buildBinary(std::move(items), 1);
    const Bvh bvh = buildBvh(c.triangles);
    // Below kSahDepth items are halved; a node of eight children spans at least one binary level.
    const double bound = kSahDepth + std::ceil(std::log2(c.triangles.size()));
    record.add({std::string(c.name) + ", depth; naive: leaves of one", "builder",
                c.triangles.size(), std::nullopt, static_cast<double>(bvh.depth), bound,
                fmt::format("levels ({})", depthOf(binary, binary.root()))});

    std::mt19937 random(12);
    std::uniform_real_distribution<float> place(-1.0F, 1.0F);
    std::vector<TestRay> rays(amount(full, 1ULL << 12, 1ULL << 15));
    glm::vec3 eye(0.0F);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (i % 64 == 0) eye = {place(random), place(random), 2.0F};
      // Targets approach the centre, where the cascade ends.
      const float near = std::pow(0.5F, static_cast<float>(i % 40));
      rays[i] = rayOf(eye, glm::vec3(near * place(random), near * place(random), -near) - eye);
    }
    // A tree that is one chain of leaves, without boxes.
    Bvh flat;
    flat.triangles.assign(c.triangles.begin(), c.triangles.end());
    for (std::size_t i = 0; i < flat.triangles.size(); ++i)
      flat.triangles[i].more = static_cast<std::uint32_t>(flat.triangles.size() - 1 - i);
    flat.root = shared::REF_LEAF;
    std::vector<TestHit> truth(rays.size());
    twins()[1]->closest(flat, rays, truth.data());
    for (const auto& subject : subjects(bvh)) {
      const auto hits = subject->closest(rays);
      std::uint64_t differ = 0, met = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        differ += hits[i].id != truth[i].id ? 1 : 0;
        met += truth[i].id != shared::NO_HIT ? 1 : 0;
      }
      EXPECT_GT(met, rays.size() / 10);
      // With fused operations, ties between edges of two shells may have the other winner.
      if (subject->name == "C++ contracted") continue;
      record.add({std::string(c.name) + ", against a loop", subject->name, rays.size(),
                  std::nullopt, static_cast<double>(differ), 0.0, "hits"});
    }
  }
}

}  // namespace
}  // namespace laver::test
