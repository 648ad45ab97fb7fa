#include <gtest/gtest.h>

#include "render/plan.h"
#include "render/traversal.h"

namespace laver {
namespace {

VkPhysicalDeviceLimits lavapipeLimits() {
  VkPhysicalDeviceLimits limits{};
  limits.maxStorageBufferRange = 128U << 20;
  limits.maxTexelBufferElements = 128U << 20;
  for (auto& count : limits.maxComputeWorkGroupCount) count = 65535;
  return limits;
}

TEST(RenderPlan, RegionHasTheApronInsideTheFilmOnly) {
  EXPECT_EQ(regionOf({0, 0, 100, 50}, 2, 100, 50), glm::uvec4(0, 0, 100, 50));
  EXPECT_EQ(regionOf({10, 20, 30, 40}, 2, 100, 50), glm::uvec4(8, 18, 24, 24));
  EXPECT_EQ(regionOf({1, 0, 100, 49}, 2, 100, 50), glm::uvec4(0, 0, 100, 50));
}

/// Every row is in one band, and no pass holds more than the plan says or the device allows.
void expectFits(int width, int height, std::uint32_t apron, std::uint32_t samples) {
  const auto limits = lavapipeLimits();
  const Crop film{0, 0, width, height};
  const RenderPlan plan = planRender(limits, film, width, height, apron, samples, 0);
  ASSERT_GE(plan.bandRows, 1U);
  ASSERT_GE(plan.samplesAPass, 1U);
  ASSERT_LE(plan.samplesAPass, samples);
  EXPECT_LE(plan.sampleSlots * kSampleBytes, limits.maxStorageBufferRange);
  EXPECT_TRUE(plan.samplesAPass == samples || plan.samplesAPass % shared::GATHER_SAMPLES == 0);
  EXPECT_LE(plan.bandPixels * sizeof(shared::FilmPixel), limits.maxStorageBufferRange);
  for (int y = 0; y < height; y += static_cast<int>(plan.bandRows)) {
    const Crop band{0, y, width, std::min(height, y + static_cast<int>(plan.bandRows))};
    const glm::uvec4 region = regionOf(band, apron, width, height);
    ASSERT_LE(std::uint64_t{region.z} * region.w * plan.samplesAPass, plan.sampleSlots);
  }
  // Turns of gather.comp's loops: groups of samples, rows, samples, columns.
  const std::uint64_t rows = plan.gatherRows + 2 * apron, columns = 2 * apron + 1;
  EXPECT_LT((plan.samplesAPass + 3) / 4 * (1 + rows) + plan.samplesAPass * rows * (1 + columns),
            65535U);
}

TEST(RenderPlan, AnyFilmFitsTheDevice) {
  expectFits(1280, 720, 2, 1);
  expectFits(1280, 720, 2, 4096);
  expectFits(1, 1, 2, 65536);
  expectFits(16384, 16384, 2, 1);
  expectFits(16384, 16384, 1, 16);
  expectFits(7, 100000, 2, 3);
  expectFits(640, 480, 20, 64);
}

TEST(RenderPlan, AFilterTooWideIsRefusedWithBothNumbers) {
  try {
    planRender(lavapipeLimits(), {0, 0, 64, 64}, 64, 64, 200, 1, 0);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::Device);
    EXPECT_EQ(std::string(error.what()),
              "the filter reaches 200 pixels to each side; gathering takes 161603 loop iterations, "
              "one invocation may run 60000");
  }
}

TEST(RenderPlan, AFilmTooWideIsRefusedByTheLimitsName) {
  VkPhysicalDeviceLimits limits = lavapipeLimits();
  limits.maxStorageBufferRange = 1U << 20;
  try {
    planRender(limits, {0, 0, 100000, 64}, 100000, 64, 2, 1, 0);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("maxStorageBufferRange"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("500000"), std::string::npos);
  }
}

TEST(TooDenseForPackets, BeginsBeyondTwoTrianglesToARay) {
  Scene scene;
  scene.camera.width = 10;
  scene.camera.height = 20;
  scene.meshes.resize(1);
  const auto dense = [&](std::uint32_t samples, std::size_t triangles) {
    scene.sampler.sampleCount = samples;
    scene.meshes[0].triangles.resize(triangles);
    return tooDenseForPackets(scene);
  };
  EXPECT_FALSE(dense(1, 400));
  EXPECT_TRUE(dense(1, 401));
  EXPECT_FALSE(dense(4, 1600));
  EXPECT_TRUE(dense(4, 1601));
  // More than 16 samples of a pixel share no more of what a packet walks through.
  EXPECT_TRUE(dense(64, 6401));
}

TEST(PacketWindow, NarrowsWithThePrimitivesAndHolds) {
  EXPECT_EQ(packetWindow(0), 1.0F);
  EXPECT_EQ(packetWindow(12), 1.0F);
  EXPECT_FLOAT_EQ(packetWindow(6400), 0.1F);
  EXPECT_FLOAT_EQ(packetWindow(25600), 0.05F);
  EXPECT_EQ(packetWindow(10'000'000), 0.02F);
}

}  // namespace
}  // namespace laver
