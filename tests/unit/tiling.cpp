#include "render/tiling.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/traversal.h"

namespace laver::test {
namespace {

VkPhysicalDeviceLimits lavapipeLimits() {
  VkPhysicalDeviceLimits limits{};
  limits.maxStorageBufferRange = 128U << 20;
  limits.maxTexelBufferElements = 128U << 20;
  for (auto& count : limits.maxComputeWorkGroupCount) count = 65535;
  return limits;
}

TEST(Tiling, RegionHasTheApronInsideTheFilmOnly) {
  EXPECT_EQ(regionOf({0, 0, 100, 50}, 2, 100, 50), glm::uvec4(0, 0, 100, 50));
  EXPECT_EQ(regionOf({10, 20, 30, 40}, 2, 100, 50), glm::uvec4(8, 18, 24, 24));
  EXPECT_EQ(regionOf({1, 0, 100, 49}, 2, 100, 50), glm::uvec4(0, 0, 100, 50));
}

/// Expects that every row is in one band, and that no pass exceeds the plan or the device's limits.
void expectFits(int width, int height, std::uint32_t apron, std::uint32_t samples) {
  const auto limits = lavapipeLimits();
  const Crop film{0, 0, width, height};
  const Tiling plan = tile(limits, {film, width, height, apron, samples});
  ASSERT_GE(plan.bandRows, 1U);
  ASSERT_GE(plan.samplesPerPass, 1U);
  ASSERT_LE(plan.samplesPerPass, samples);
  EXPECT_LE(plan.sampleSlots * kSampleBytes, limits.maxStorageBufferRange);
  EXPECT_TRUE(plan.samplesPerPass == samples || plan.samplesPerPass % shared::GATHER_SAMPLES == 0);
  EXPECT_LE(plan.bandPixels * sizeof(shared::FilmPixel), limits.maxStorageBufferRange);
  for (int y = 0; y < height; y += static_cast<int>(plan.bandRows)) {
    const Crop band{0, y, width, std::min(height, y + static_cast<int>(plan.bandRows))};
    const glm::uvec4 region = regionOf(band, apron, width, height);
    ASSERT_LE(std::uint64_t{region.z} * region.w * plan.samplesPerPass, plan.sampleSlots);
  }
  // Iterations of film/gather.glsl's loops: groups of samples, rows, samples, columns.
  constexpr std::uint64_t kGroup = shared::GATHER_SAMPLES;
  const std::uint64_t rows = plan.gatherRows + 2 * apron, columns = 2 * apron + 1;
  const std::uint64_t groups = (plan.samplesPerPass + kGroup - 1) / kGroup;
  EXPECT_LT(groups * (1 + rows) + plan.samplesPerPass * rows * (1 + columns), 65535U);
}

TEST(Tiling, AnyFilmFitsTheDevice) {
  expectFits(1280, 720, 2, 1);
  expectFits(1280, 720, 2, 4096);
  expectFits(1, 1, 2, 65536);
  expectFits(16384, 16384, 2, 1);
  expectFits(16384, 16384, 1, 16);
  expectFits(7, 100000, 2, 3);
  expectFits(640, 480, 20, 64);
}

TEST(Tiling, ATooWideFilterIsRefusedWithBothNumbers) {
  try {
    tile(lavapipeLimits(), {{0, 0, 64, 64}, 64, 64, 200, 1});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::Device);
    EXPECT_EQ(std::string(error.what()),
              "the filter reaches 200 pixels to each side; gathering takes 161603 loop iterations, "
              "one invocation may run 60000");
  }
}

TEST(Tiling, ATooWideFilmIsRefusedWithTheLimitsName) {
  VkPhysicalDeviceLimits limits = lavapipeLimits();
  limits.maxStorageBufferRange = 1U << 20;
  try {
    tile(limits, {{0, 0, 100000, 64}, 100000, 64, 2, 1});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("maxStorageBufferRange"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("500000"), std::string::npos);
  }
}

class TraversalOf : public testing::Test {
 protected:
  TraversalOf() {
    device_.subgroupSize = 8;
    device_.shuffles = device_.longs = true;
    scene_.meshes.resize(1);
  }
  std::string of(int width, int height, std::uint32_t samples, std::size_t triangles,
                 const std::string& wanted = {}) {
    scene_.camera.width = width;
    scene_.camera.height = height;
    scene_.sampler.sampleCount = samples;
    scene_.meshes[0].triangles.resize(triangles);
    return traversalName(traversalOf(scene_, device_, wanted).traversal);
  }
  DeviceInfo device_;
  Scene scene_;
};

TEST_F(TraversalOf, IsLaneBeyondTwoTrianglesPerRay) {
  EXPECT_EQ(of(10, 20, 1, 400), "packet32");
  EXPECT_EQ(of(10, 20, 1, 401), "lane");
  EXPECT_EQ(of(10, 20, 4, 1600), "packet32");
  EXPECT_EQ(of(10, 20, 4, 1601), "lane");
  // Beyond 16 samples per pixel, packets visit no more nodes together.
  EXPECT_EQ(of(10, 20, 64, 6401), "lane");
  EXPECT_EQ(of(10, 20, 1, 401, "packet"), "packet32");
  EXPECT_EQ(of(10, 20, 1, 401, "packet64"), "packet64");
}

TEST_F(TraversalOf, IsLargePacketsOfManyRaysAndFewTriangles) {
  EXPECT_EQ(of(1024, 1024, 4, 12), "packet64");
  EXPECT_EQ(of(1024, 1023, 4, 12), "packet32");
  EXPECT_EQ(of(1024, 1023, 4, 12, "packet64"), "packet64");
  EXPECT_EQ(of(64, 64, 1024, 16384), "packet64");
  EXPECT_EQ(of(64, 64, 1024, 16385), "packet32");
  EXPECT_EQ(of(64, 64, 1024, 16385, "packet"), "packet32");
  EXPECT_EQ(of(64, 64, 1024, 12, "packet32"), "packet32");
  EXPECT_EQ(of(64, 64, 1024, 12, "lane"), "lane");
}

TEST_F(TraversalOf, RefusesUnsupportedAndUnknownNames) {
  device_.longs = false;
  EXPECT_EQ(of(1024, 1024, 4, 12), "lane");
  for (const char* wanted : {"packet", "packet32", "packet64"})
    EXPECT_THROW(of(8, 8, 1, 12, wanted), Error) << wanted;
  EXPECT_EQ(of(8, 8, 1, 12, "lane"), "lane");
  device_.longs = true;
  EXPECT_THROW(of(8, 8, 1, 12, "packet16"), Error);
}

TEST(PacketWindow, NarrowsWithThePrimitivesAndHolds) {
  EXPECT_EQ(packetWindow(0), 1.0F);
  EXPECT_EQ(packetWindow(12), 1.0F);
  EXPECT_FLOAT_EQ(packetWindow(6400), 0.1F);
  EXPECT_FLOAT_EQ(packetWindow(25600), 0.05F);
  EXPECT_EQ(packetWindow(10'000'000), 0.02F);
}

}  // namespace
}  // namespace laver::test
