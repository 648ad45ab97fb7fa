// Which of coincident triangles a ray hits, and every bit of the hit, depend only on the scene: not
// on the tree, the width of its nodes, the order of children, or the traversal. Threads, tiles and
// passes are tested in pictures/same_bits.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include "bvh/walk.h"
#include "pictures/harness.h"
#include "stability/meshes.h"
#include "stability/naive.h"
#include "stability/other_trees.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

/// Two copies of a wavy sheet; the triangles of the second list their corners rotated by one.
/// `listed` has them as listed, for the naive method, `sorted` as packed. Ids follow file order.
struct Sheets {
  Sheets() {
    const Mesh sheet = gridMesh(48, [](double x, double y) {
      return glm::dvec3(x, y, 0.1 * std::sin(5 * x) * std::cos(4 * y));
    });
    for (const glm::dvec3& p : sheet.positions) positions.emplace_back(p);
    triangles = sheet.triangles;
    for (const glm::uvec3& t : sheet.triangles) triangles.emplace_back(t.y, t.z, t.x);
    sorted = closedMesh(positions, triangles);
    listed = inListedOrder(sorted);
  }
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  ClosedMesh sorted;
  Bvh listed;
};

std::array<std::uint32_t, 4> bitsOf(const TestHit& hit) {
  return std::bit_cast<std::array<std::uint32_t, 4>>(hit);
}

/// The first one visited with the smallest t wins, as usual.
std::uint32_t naiveWinner(const Bvh& bvh, const TestRay& ray) {
  std::uint32_t best = shared::NO_HIT;
  const auto box = shared::boxRayOf(ray.origin, ray.direction, shared::shearOf(ray.direction).axis);
  float nearest = INFINITY;
  walk(
      bvh, octantOf(ray.direction),
      [&](const shared::Child& child) {
        const auto span = shared::boxSpan(box, 0.0F, child.lo, child.hi);
        return span.near <= span.far;
      },
      [&](const shared::Triangle& t) {
        TestHit hit{};
        if (naive::moellerTrumbore(ray.origin, ray.direction, t, 0.0F, INFINITY, hit) &&
            hit.t < nearest) {
          nearest = hit.t;
          best = t.id;
        }
        return false;
      });
  return best;
}

/// Number of floats that differ when one picture is rendered in different tilings.
std::uint64_t otherBits(const std::string& traversal) {
  const Scene scene = smallScene("curved-normals.xml", 90, 3);
  VulkanOptions vulkan;
  vulkan.device = testDevice();
  vulkan.traversal = traversal;
  const Image whole = render(scene, vulkan);
  std::uint64_t differ = differingFloats(whole, render(scene, vulkan));
  VulkanOptions pieces = vulkan;
  pieces.samplesInFlight = 1000;
  Stats stats;
  differ += test::differingFloats(whole, Renderer(pieces).render(scene, {}, stats).image);
  EXPECT_GT(stats.passes, 10U);
  RenderOptions cropped;
  cropped.threads = 1;
  cropped.crop = Crop{33, 5, 71, 44};
  const Image part = render(scene, vulkan, cropped);
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        differ += part.at(x, y, c) == whole.at(x + 33, y + 5, c) ? 0 : 1;
  return differ;
}

LAVER_STABILITY(Order, "Ties: child order, triangle order, node width, traversal") {
  const Sheets sheets;
  const auto half = static_cast<std::uint32_t>(sheets.triangles.size() / 2);
  constexpr std::size_t kSide = 96;
  const std::size_t step = full ? 8 : 2, side = step * kSide;
  std::vector<TestRay> rays;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const glm::vec3 target((2.0F * static_cast<float>(x) + 1.0F) / static_cast<float>(side) - 1,
                             (2.0F * static_cast<float>(y) + 1.0F) / static_cast<float>(side) - 1,
                             0.0F);
      const glm::vec3 eye(0.3F, 0.2F, 3.0F);
      rays.push_back(rayOf(eye, 0.97F * target - eye));
    }

  std::mt19937 random(8);
  std::vector<std::pair<const char*, std::pair<Bvh, Bvh>>> trees;
  trees.push_back({"the tree", {sheets.sorted.bvh, sheets.listed}});
  {
    std::mt19937 again = random;
    trees.push_back({"children shuffled",
                     {withShuffledChildren(sheets.sorted.bvh, random),
                      withShuffledChildren(sheets.listed, again)}});
    again = random;
    trees.push_back({"triangles shuffled",
                     {fromShuffledTriangles(sheets.sorted.bvh.triangles, random),
                      fromShuffledTriangles(sheets.listed.triangles, again)}});
  }
  trees.push_back({"two children a node",
                   {withTwoChildren(sheets.sorted.bvh), withTwoChildren(sheets.listed)}});

  // Of the first tree. Twins with fused operations round differently from the traversals, so each
  // is compared with itself.
  std::map<const Twin*, std::vector<TestHit>> wantedOf;
  std::vector<std::uint32_t> naiveWanted;
  Bitmap before(kSide, kSide, {}), after(kSide, kSide, {});
  for (const auto& [name, tree] : trees) {
    std::uint64_t naiveDiffer = 0;
    std::vector<std::uint32_t> winners;
    winners.reserve(rays.size());
    for (const auto& ray : rays) winners.push_back(naiveWinner(tree.second, ray));
    if (naiveWanted.empty()) naiveWanted = winners;
    for (std::size_t i = 0; i < rays.size(); ++i) naiveDiffer += winners[i] != naiveWanted[i];
    for (const auto& subject : subjects(tree.first)) {
      const auto hits = subject->closest(rays);
      std::vector<TestHit>& wanted = wantedOf[subject->twin];
      if (wanted.empty()) wanted = hits;
      std::uint64_t differ = 0;
      for (std::size_t i = 0; i < hits.size(); ++i) {
        differ += bitsOf(hits[i]) != bitsOf(wanted[i]) ? 1 : 0;
        // The first copy wins every tie.
        differ += hits[i].id != shared::NO_HIT && hits[i].id >= half ? 1 : 0;
      }
      const bool same = naiveDiffer == 0;
      record.add({name, subject->name, rays.size(),
                  same ? std::nullopt : std::optional(static_cast<double>(naiveDiffer)),
                  static_cast<double>(differ), 0.0, "hits"});
      if (subject->twin != nullptr) continue;
      for (std::size_t y = 0; y < kSide; ++y)
        for (std::size_t x = 0; x < kSide; ++x) {
          const std::size_t i = (y * side + x) * step, p = y * kSide + x;
          if (winners[i] == shared::NO_HIT || hits[i].id == shared::NO_HIT) continue;
          const Rgb8 own{70, 130, 200}, copy{220, 120, 40};
          before.pixels[p] = winners[i] < half ? own : copy;
          after.pixels[p] = hits[i].id < half ? own : copy;
        }
    }
  }
  for (const std::string traversal : {"lane", "packet32", "packet64"})
    record.add({"run again, in small pieces, cropped on one thread", traversal,
                std::uint64_t{4} * 90 * 60, std::nullopt, static_cast<double>(otherBits(traversal)),
                0.0, "floats"});
  record.picture(
      "Ties: a sheet and its exact copy, whose triangles list their corners from another one on; "
      "blue where a ray met the first, orange the copy.",
      before, after);
}

}  // namespace
}  // namespace laver::test
