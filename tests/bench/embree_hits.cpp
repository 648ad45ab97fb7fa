// The ray bench is fair only if both sides trace the same rays through the same mesh.
#include <gtest/gtest.h>

#include "bench/embree_rays.h"
#include "bench/embree_scene.h"
#include "bench/ray_sets.h"
#include "bench/scenes.h"
#include "vulkan/device.h"
#include "vulkan/instance.h"

namespace laver::bench {
namespace {

class EmbreeHits : public testing::Test {
 protected:
  /// Share of the rays through a torus' film that hit another triangle.
  double differing(const std::vector<TestHit>& hits) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) count += hits[i].id != laver_[i].id ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(hits.size());
  }

  const Scene scene_ = benchScene("torus", 0, "depth", 1);
  const Packed data_ = pack(scene_, {}, uploadsOf(scene_, {}));
  const std::vector<TestRay> rays_ = cameraRays(data_);
  const Instance instance_{false};
  const Device device_{choosePhysicalDevice(instance_, "cpu")};
  test::RayTracer tracer_{device_, data_.bvh, "lane"};
  const std::vector<TestHit> laver_ = tracer_.closest(rays_);
  const EmbreeDevice embree_{"threads=2"};
  const EmbreeMesh mesh_{scene_};
  const EmbreeScene robust_{embree_, mesh_, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM};
};

TEST_F(EmbreeHits, AreLaversTrianglesAtEveryPacketWidth) {
  for (const int width : {1, 8, 16}) {
    EmbreeRays embree(rays_, {});
    embree.closest(robust_.get(), width, true, 2);
    const auto hits = embree.hits();
    EXPECT_EQ(hits.size(), rays_.size());
    // Rounding decides at edges and silhouettes: 5 of a million rays differed on the bunny.
    EXPECT_LT(differing(hits), 1e-3) << width;
  }
  auto others = rays_;
  for (TestRay& ray : others)
    ray.direction.x += 0.01F * ray.direction.z;  // a pixel or more sideways
  EmbreeRays embree(others, {});
  embree.closest(robust_.get(), 16, true, 2);
  EXPECT_GT(differing(embree.hits()), 1e-2);
}

TEST_F(EmbreeHits, AgreeWithLaverOnShadows) {
  Scene lit = benchScene("torus", 0, "direct_whitted", 1);
  const Packed data = pack(lit, {}, uploadsOf(lit, {}));
  const auto points = litPoints(data, rays_, laver_);
  const glm::vec3 light = data.lights.front().position;
  const auto ours = tracer_.visible(light, points);
  EmbreeRays embree({}, points);
  embree.visible(robust_.get(), 16, light, 2);
  const auto theirs = embree.seen();
  ASSERT_EQ(theirs.size(), ours.size());
  std::size_t differ = 0, lit_ = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    differ += ours[i] != theirs[i] ? 1 : 0;
    lit_ += ours[i];
  }
  EXPECT_GT(lit_, points.size() / 20);
  EXPECT_LT(static_cast<double>(differ), 1e-3 * static_cast<double>(points.size()));
}

}  // namespace
}  // namespace laver::bench
