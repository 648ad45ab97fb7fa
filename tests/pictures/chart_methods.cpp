// The intersection methods that a chart compares, and laver's own.
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "lab/chart/methods/judge.h"
#include "lab/chart/methods/methods.h"
#include "lab/chart/methods/quantise.h"
#include "pictures/harness.h"
#include "render/packed.h"
#include "shared/triangle.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

using namespace chart;

/// A closed sphere in front of the camera.
Scene sphereScene() {
  Scene scene;
  scene.meshes.push_back(bumpySphere(40, 60, 0.05, {0.0, 0.0, 0.0}));
  scene.camera.width = scene.camera.height = 64;
  scene.camera.toWorld[3] = {0.0, 0.0, -5.0, 1.0};
  return scene;
}

Bvh sphereTree() { return pack(sphereScene(), {}, uploadsOf(sphereScene(), {})).bvh; }

TEST(ChartMethods, QuantisedBoxesContainTheOriginalOnes) {
  for (const Bvh& bvh : {sphereTree(), withTightBoxes(sphereTree())}) {
    const auto texels = quantised(bvh);
    ASSERT_EQ(texels.size(), bvh.nodes.size() * 9);
    double grown = 0, count = 0;
    for (std::size_t n = 0; n < bvh.nodes.size(); ++n)
      for (std::size_t c = 0; c < 8; ++c) {
        const shared::Child& child = bvh.nodes[n].child[c];
        const glm::uvec4 texel = texels[n * 9 + 1 + c];
        EXPECT_EQ(texel.z, child.ref);
        if (child.ref == shared::REF_NONE) continue;
        const glm::vec3 lo = sideOf(texels[n * 9], texel.x), hi = sideOf(texels[n * 9], texel.y);
        for (int a = 0; a < 3; ++a) {
          EXPECT_LE(lo[a], child.lo[a]);
          EXPECT_GE(hi[a], child.hi[a]);
          grown += static_cast<double>((hi[a] - lo[a]) - (child.hi[a] - child.lo[a]));
        }
        count += 3;
      }
    // At high a step of 2 / 255 of the sphere on each side, and far less in small nodes.
    EXPECT_GT(grown, 0.0);
    EXPECT_LT(grown / count, 0.01);
  }
}

TEST(ChartMethods, TightBoxesLieInsideTheBuildersBoxes) {
  const Bvh grown = sphereTree(), tight = withTightBoxes(grown);
  for (std::size_t n = 0; n < grown.nodes.size(); ++n)
    for (std::size_t c = 0; c < 8; ++c) {
      if (grown.nodes[n].child[c].ref == shared::REF_NONE) continue;
      for (int a = 0; a < 3; ++a) {
        EXPECT_GT(tight.nodes[n].child[c].lo[a], grown.nodes[n].child[c].lo[a]);
        EXPECT_LT(tight.nodes[n].child[c].hi[a], grown.nodes[n].child[c].hi[a]);
      }
    }
}

TEST(ChartMethods, MoellerTrumboreLosesRaysAtEdgesAndOursNone) {
  const auto points = chartMethods(sphereScene(), testDevice(), 1, {});
  ASSERT_EQ(points.size(), 24U);
  for (const MethodPoint& m : points) {
    SCOPED_TRACE(m.triangles + ", " + m.boxes + ", " + m.nodes);
    EXPECT_GT(m.nanoseconds, 0.0);
    EXPECT_GT(m.rays, 500U);
    if (m.triangles == "Moeller-Trumbore") {
      EXPECT_GT(m.unexplained, m.rays / 100);
    }
    EXPECT_LT(m.unexplained, m.rays / 5);
    if (m.triangles != "Moeller-Trumbore") {
      EXPECT_LT(m.unexplained, m.rays / 100);
    }
    if (m.triangles != "Moeller-Trumbore" && m.boxes == "ours") {
      EXPECT_EQ(m.unexplained, 0U);
    }
    if (m.triangles == "ours" && m.boxes == "ours") {
      EXPECT_LT(m.t99, 4.0);  // as in tests/stability
      EXPECT_LT(m.normal99, 8.0);
    }
    const MethodPoint copy = methodFromJson(toJson(m));
    EXPECT_EQ(copy.boxes, m.boxes);
    EXPECT_EQ(copy.unexplained, m.unexplained);
    EXPECT_EQ(copy.quartiles[1], m.quartiles[1]);
  }
  EXPECT_TRUE(chartMethods(sphereScene(), testDevice(), 1, [] { return true; }).empty());
  EXPECT_TRUE(chartMethods(Scene(), testDevice(), 1, {}).empty());
}

/// Nearest hits by laver's triangle test without a tree, but with another inside test of the
/// smallest and the largest edge function.
std::vector<MethodHit> hitsBy(const Bvh& bvh, std::span<const MethodRay> rays,
                              bool (*inside)(float low, float high)) {
  std::vector<MethodHit> hits;
  for (const MethodRay& ray : rays) {
    const shared::Shear shear = shared::shearOf(ray.direction);
    MethodHit hit{glm::vec3(0.0F), std::numeric_limits<float>::infinity(), shared::NO_HIT};
    for (const shared::Triangle& t : bvh.triangles) {
      const auto permuted = [&](glm::vec3 p) { return shared::permute(shear, p - ray.origin); };
      const glm::vec3 a = permuted(t.a), b = permuted(t.b), c = permuted(t.c);
      const shared::Edges e = shared::edgesOf(shear, a, b, c);
      const float depth = shared::depthOf(e, a.z, b.z, c.z);
      if (e.sum != 0.0F && inside(std::min({e.a, e.b, e.c}), std::max({e.a, e.b, e.c})) &&
          depth >= 0.0F && (depth < hit.t || (depth == hit.t && t.id < hit.id)))
        hit = {glm::vec3(0.0F), depth, t.id};
    }
    hits.push_back(hit);
  }
  return hits;
}

TEST(ChartMethods, AWrongComparisonIsDetectedAtEdges) {
  const Packed data = pack(sphereScene(), {}, uploadsOf(sphereScene(), {}));
  const glm::vec3 origin(data.params.origin);
  MethodJudge judge(data.bvh);
  std::vector<MethodRay> rays;
  for (int i = 0; i < 300; ++i) {
    const auto at = static_cast<float>(i);
    rays.push_back(
        {origin, 0.0F, glm::vec3(0.4F * std::sin(at), 0.4F * std::cos(at), 0) - origin, 1e30F});
  }
  const auto aimed = judge.aimed(rays);
  ASSERT_EQ(aimed.size(), rays.size());
  judge.expect(aimed);
  const auto unexplained = [&](bool (*inside)(float, float)) {
    return judge.unexplained(hitsBy(data.bvh, aimed, inside));
  };
  EXPECT_EQ(unexplained([](float low, float high) { return low >= 0 || high <= 0; }), 0U);
  // Edges excluded; < instead of >=; one of the two windings missing.
  EXPECT_GT(unexplained([](float low, float high) { return low > 0 || high < 0; }), 30U);
  EXPECT_GT(unexplained([](float low, float high) { return low < 0 || high <= 0; }), 270U);
  EXPECT_GT(unexplained([](float low, float) { return low >= 0; }), 30U);
  EXPECT_GT(unexplained([](float, float high) { return high <= 0; }), 30U);
}

TEST(ChartMethods, AWrongHitIsNotExplained) {
  const Packed data = pack(sphereScene(), {}, uploadsOf(sphereScene(), {}));
  MethodJudge judge(data.bvh);
  const std::vector<MethodRay> rays{
      {data.params.origin, 0.0F, -data.params.origin + glm::vec3(0.01F, 0.02F, 0.0F), 1e30F}};
  judge.expect(rays);
  MethodHit hit{glm::vec3(0.0F), 1.0F, shared::NO_HIT};
  EXPECT_EQ(judge.unexplained(std::span(&hit, 1)), 1U);
  std::size_t right = 0;
  for (std::uint32_t id = 0; id < data.bvh.triangles.size(); ++id) {
    hit.id = id;
    right += judge.unexplained(std::span(&hit, 1)) == 0 ? 1 : 0;
  }
  EXPECT_EQ(right, 1U);
  // At a corner, any of its triangles is explained, and a miss is not.
  const auto aimed = judge.aimed(rays);
  ASSERT_EQ(aimed.size(), 1U);  // at a corner
  judge.expect(aimed);
  right = 0;
  for (std::uint32_t id = 0; id < data.bvh.triangles.size(); ++id) {
    hit.id = id;
    right += judge.unexplained(std::span(&hit, 1)) == 0 ? 1 : 0;
  }
  EXPECT_GE(right, 3U);
  EXPECT_LE(right, 60U);  // the poles' triangles
  hit.id = shared::NO_HIT;
  EXPECT_EQ(judge.unexplained(std::span(&hit, 1)), 1U);
}

}  // namespace
}  // namespace laver::test
