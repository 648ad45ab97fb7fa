// Distribution of adaptive samples, and that choosing them causes no bias.
#include "render/sample_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace laver::test {
namespace {

constexpr Crop kArea{0, 0, 64, 64};

/// Pilots that are 0 except in a square whose value alternates between 0 and `height`: there s^2 is
/// height^2 / 2.
std::vector<Image> pilotsWith(Crop square, float height) {
  std::vector<Image> pilots(kPilots, rgbImage(kArea.x1, kArea.y1));
  for (std::size_t i = 0; i < pilots.size(); ++i)
    for (int y = square.y0; y < square.y1; ++y)
      for (int x = square.x0; x < square.x1; ++x)
        pilots[i].at(x, y, 1) = i % 2 == 0 ? height : 0.0F;
  return pilots;
}

TEST(SampleMap, SmoothAreasGetTheMinimum) {
  const SampleMap map = decideSamples(pilotsWith({}, 0.0F), kArea, 0.01, 256, 1);
  EXPECT_EQ(map.max(kArea), 1U);
}

TEST(SampleMap, BlocksBelowASixthOfTheErrorGetOneSample) {
  // s is 0.7071 of the height.
  constexpr Crop kBlocks{16, 16, 32, 32};
  const SampleMap below = decideSamples(pilotsWith(kBlocks, 0.0023F), kArea, 0.01, 256, 1);
  EXPECT_EQ(below.max(kArea), 1U);
  const SampleMap above = decideSamples(pilotsWith(kBlocks, 0.0024F), kArea, 0.01, 256, 1);
  EXPECT_EQ(above.samplesOf(kArea, 256), 4096U + 3U * 256U);
  // A cell that needs more samples raises its own block and no other.
  const SampleMap one = decideSamples(pilotsWith({18, 18, 19, 19}, 0.05F), kArea, 0.01, 256, 1);
  EXPECT_EQ(one.samplesOf(kArea, 256), 4096U + 3U * 64U);
  EXPECT_EQ(one.max({16, 16, 24, 24}), 4U);
}

TEST(SampleMap, ACellGetsItsVarianceOverTheSquaredErrorInStepsOfFour) {
  // A cell and the pixels around it: s^2 is 0.09 / 2, and 0.045 / 0.02^2 = 112.5.
  const SampleMap map = decideSamples(pilotsWith({19, 19, 25, 25}, 0.3F), kArea, 0.02, 256, 1);
  EXPECT_EQ(map.pixel(20, 20), 116U);
  EXPECT_EQ(map.pixel(23, 23), 116U);
  EXPECT_EQ(map.pixel(40, 20), 1U);
  // The square covers 2 of 6 columns around the neighbour: a third of s^2.
  EXPECT_EQ(map.pixel(24, 20), 40U);
}

TEST(SampleMap, NeighboursGetAQuarter) {
  // Affects one cell only: 4 of its 36 pixels, s^2 = 0.125, (0.125 * 4 / 36) / 0.01^2 = 138.9.
  const SampleMap map = decideSamples(pilotsWith({21, 21, 23, 23}, 0.5F), kArea, 0.01, 4096, 1);
  EXPECT_EQ(map.pixel(20, 20), 140U);
  for (const auto& [x, y] : {std::pair(16, 16), std::pair(20, 16), std::pair(24, 24)})
    EXPECT_EQ(map.pixel(x, y), 36U);
  EXPECT_EQ(map.pixel(28, 20), 4U);  // in their block
  EXPECT_EQ(map.pixel(32, 20), 1U);
}

TEST(SampleMap, NoPixelGetsMoreThanTheBound) {
  const SampleMap map = decideSamples(pilotsWith({19, 19, 25, 25}, 0.9F), kArea, 1e-6, 128, 1);
  EXPECT_EQ(map.pixel(20, 20), 128U);
  EXPECT_EQ(map.max(kArea), 128U);
}

TEST(SampleMap, AboveWhiteTheErrorIsRelative) {
  // Mean 3, s^2 18: 18 / 3^2 / 0.25^2 = 32.
  const SampleMap map = decideSamples(pilotsWith({16, 16, 32, 32}, 6.0F), kArea, 0.25, 4096, 1);
  EXPECT_EQ(map.pixel(20, 20), 32U);
}

TEST(SampleMap, TheCountsOfACropAreThoseOfTheWhole) {
  std::mt19937 random(3);
  std::vector<Image> pilots(kPilots, rgbImage(kArea.x1, kArea.y1));
  for (int speck = 0; speck < 60; ++speck)
    pilots[0].pixels[random() % pilots[0].pixels.size()] = 0.1F * static_cast<float>(speck % 8);
  const SampleMap whole = decideSamples(pilots, kArea, 0.02, 256, 1);
  for (int y = 0; y < 64; y += 3)
    for (int x = 0; x < 64; x += 3) {
      const Crop area = pilotArea({x, y, x + 1, y + 1}, kArea.x1, kArea.y1);
      std::vector<Image> parts;
      for (const Image& pilot : pilots) {
        Image& part = parts.emplace_back(rgbImage(area.x1 - area.x0, area.y1 - area.y0));
        for (int v = area.y0; v < area.y1; ++v)
          for (int u = area.x0; u < area.x1; ++u)
            for (std::size_t c = 0; c < 3; ++c)
              part.at(u - area.x0, v - area.y0, c) = pilot.at(u, v, c);
      }
      EXPECT_EQ(decideSamples(parts, area, 0.02, 256, 1).pixel(x, y), whole.pixel(x, y))
          << x << ' ' << y;
    }
}

TEST(SampleMap, CountsOfARegionAreThoseOfTheCellsThatItTouches) {
  SampleMap map(kArea, 4);
  map.cell(2, 1) = 20;
  const auto counts = map.counts({11, 3, 2, 2});  // pixels 11 and 12, 3 and 4
  ASSERT_EQ(counts.size(), 4U);
  EXPECT_EQ(counts[0].samples, 4U);
  EXPECT_EQ(counts[2].samples, 20U);
  EXPECT_EQ(map.max({11, 3, 13, 5}), 20U);
  EXPECT_EQ(map.max({12, 3, 16, 8}), 4U);
  EXPECT_EQ(map.samplesOf({11, 3, 13, 5}, 16), 4U + 4U + 16U + 4U);
}

/// How many of `count` samples hit a feature with probability `p` each; the gaps between such
/// samples have a geometric distribution.
double hits(std::mt19937& random, std::uint32_t count, double p) {
  double found = 0;
  for (double at = 0;; ++found) {
    const double unit = (static_cast<double>(random()) + 0.5) / 4294967296.0;
    at += 1.0 + std::floor(std::log(unit) / std::log1p(-p));
    if (at > count) return found;
  }
}

TEST(SampleMap, AFeatureHitByOneSampleInAHundredIsNotBiased) {
  // Every sample that hits the feature is 1; pilots may miss it. The random numbers are fixed.
  constexpr double kShare = 0.01;
  constexpr Crop kFilm{0, 0, 256, 256};
  std::mt19937 random(7);
  double ours = 0, kept = 0, variance = 0;
  std::uint64_t pixels = 0;
  for (int round = 0; round < 240; ++round) {
    std::vector<Image> pilots(kPilots, rgbImage(kFilm.x1, kFilm.y1));
    std::vector<double> seen(std::size_t{256} * 256, 0.0);
    for (Image& pilot : pilots)
      for (std::size_t i = 0; i < seen.size(); ++i) {
        const bool met = static_cast<double>(random()) < kShare * 4294967296.0;
        pilot.pixels[3 * i] = met ? 1.0F : 0.0F;
        seen[i] += met ? 1 : 0;
      }
    const SampleMap map = decideSamples(pilots, kFilm, 0.03, 256, 2);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const std::uint32_t count = map.pixel(static_cast<int>(i % 256), static_cast<int>(i / 256));
      const double met = hits(random, count, kShare);
      ours += met / count;
      variance += kShare * (1.0 - kShare) / count;
      kept += (met + seen[i]) / (count + kPilots);
    }
    pixels += seen.size();
  }
  const double truth = kShare * static_cast<double>(pixels);
  EXPECT_LT(std::sqrt(variance) / truth, 0.001);
  EXPECT_NEAR(ours / truth, 1.0, 0.002);
  EXPECT_LT(kept / truth, 0.95);  // keeping the pilots would cause this bias
}

}  // namespace
}  // namespace laver::test
