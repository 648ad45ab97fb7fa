// Rays from memory: all traversals against the double-precision tree, and against each other.
#include <cstring>
#include <random>

#include "pictures/harness.h"
#include "reference/tree.h"
#include "render/packed.h"
#include "render/traversal.h"
#include "support/bumpy_sphere.h"
#include "trace/ray_tracer.h"

namespace laver::test {
namespace {

using glm::vec3;

Scene closedBumpySphere() {
  Scene scene;
  scene.meshes.push_back(bumpySphere(24, 40, 0.05, {3.0, 0.0, 0.0}));
  return scene;
}

class TraceRays : public testing::Test {
 protected:
  vec3 point(float size) { return vec3(number(size), number(size), number(size)); }
  float number(float size) { return std::uniform_real_distribution(-size, size)(engine_); }

  /// Blocks of 64 rays of one origin, narrow and wide, some with tmin and tmax inside the scene;
  /// the last block is shorter.
  std::vector<TestRay> someRays() {
    std::vector<TestRay> rays;
    for (int block = 0; block < 151; ++block) {
      const vec3 origin = point(block % 3 == 0 ? 0.2F : 4.0F);
      const vec3 aim = point(0.5F) - origin;
      const float width = block % 5 == 0 ? 2.0F : 0.05F;
      for (int i = 0; i < (block == 150 ? 9 : 64); ++i) {
        const float far = block % 7 == 0 ? 1.0F + number(0.9F) : 1e10F;
        rays.push_back({origin, i % 4 == 0 ? 0.5F : 0.0F, aim + point(width), far});
      }
    }
    return rays;
  }

  Instance instance_{false};
  Device device_{choosePhysicalDevice(instance_, testDevice())};
  Packed scene_ = pack(closedBumpySphere(), {}, uploadsOf(closedBumpySphere(), {}));
  RayTracer lane_{device_, scene_.bvh, "lane"};
  std::mt19937 engine_{17};
};

reference::Tree doubleTree(const Bvh& bvh) {
  std::vector<reference::Triangle> triangles;
  for (const shared::Triangle& t : bvh.triangles) triangles.emplace_back(t.a, t.b, t.c, t.id);
  return reference::Tree(triangles);
}

TEST_F(TraceRays, NearestHitsEqualTheReferences) {
  const auto tree = doubleTree(scene_.bvh);
  const std::vector<TestRay> rays = someRays();
  const std::vector<TestHit> hits = lane_.closest(rays);
  EXPECT_EQ(lane_.incomplete(), 0U);
  EXPECT_GT(lane_.seconds(), 0.0);
  int met = 0, otherSide = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const TestRay& ray = rays[i];
    const auto wanted = tree.closest({ray.origin, ray.direction}, static_cast<double>(ray.tmin),
                                     static_cast<double>(ray.tmax));
    ASSERT_EQ(hits[i].id != shared::NO_HIT, wanted.has_value()) << i;
    if (!wanted) {
      EXPECT_EQ(hits[i].t, ray.tmax);
      continue;
    }
    ++met;
    // Rounding may put a ray on the other side of an edge: about 1e-7 of a triangle's size of 0.1
    // per ray.
    otherSide += hits[i].id != wanted->triangle->id;
    // 2^-24 * |origin| / |direction|, about ten times; directions are longer than 0.1.
    EXPECT_NEAR(static_cast<double>(hits[i].t), wanted->t, 2e-5) << i;
    if (hits[i].id != wanted->triangle->id) continue;
    // The same relative to an edge of 0.1, seen with a slope of up to 100.
    EXPECT_NEAR(static_cast<double>(hits[i].u), wanted->weights[1], 1e-3) << i;
    EXPECT_NEAR(static_cast<double>(hits[i].v), wanted->weights[2], 1e-3) << i;
  }
  EXPECT_GT(met, 3000);
  EXPECT_LT(otherSide, 5);
}

TEST_F(TraceRays, OcclusionEqualsTheReferences) {
  const auto tree = doubleTree(scene_.bvh);
  for (const vec3 light :
       {vec3(0.1F, 0.0F, 0.2F), vec3(1.5F, 2.0F, -1.0F), vec3(30.0F, 50.0F, 9.0F)}) {
    std::vector<vec3> points;
    points.reserve(2009);
    for (int i = 0; i < 2009; ++i) points.push_back(point(1.0F));
    points.back().x = std::numeric_limits<float>::quiet_NaN();
    const auto seen = lane_.visible(light, points);
    EXPECT_EQ(lane_.incomplete(), 0U);
    int blocked = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(seen[i] == 0, std::isnan(points[i].x) || tree.blocked(points[i], light)) << i;
      blocked += seen[i] == 0;
    }
    EXPECT_GT(blocked, 100);
    EXPECT_LT(blocked, 1900);
  }
}

TEST_F(TraceRays, PacketsGiveTheSameBits) {
  if (!runsPackets(device_.info())) GTEST_SKIP() << "no subgroups of 8, or no 64-bit integers";
  const std::vector<TestRay> rays = someRays();
  std::vector<vec3> points;
  points.reserve(4000);
  for (int i = 0; i < 4000; ++i) points.push_back(point(1.0F));
  const vec3 light(1.5F, 2.0F, -1.0F);
  for (const char* traversal : {"packet32", "packet64"}) {
    RayTracer packet(device_, scene_.bvh, traversal);
    const auto a = lane_.closest(rays), b = packet.closest(rays);
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(TestHit)), 0) << traversal;
    EXPECT_EQ(lane_.visible(light, points), packet.visible(light, points)) << traversal;
    EXPECT_EQ(lane_.incomplete() + packet.incomplete(), 0U) << traversal;
  }
}

}  // namespace
}  // namespace laver::test
