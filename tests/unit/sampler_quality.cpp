// How well `stratified` and `sobol` fill a pixel. The test examines the reference's samples, since
// the device draws the same ones to the bit (tests/trace/sample_positions.cpp).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/sampler.h"

namespace laver::test {
namespace {

using namespace reference;

Camera film(int width, int height) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  return camera;
}

/// Exact position of a sample in its pixel.
glm::dvec2 placeOf(const Camera& camera, const Sampler& sampler, int x, int y, std::uint32_t s) {
  return glm::dvec2(samplePosition(camera, sampler, x, y, s)) - glm::dvec2(x, y);
}

/// Whether each of the columns x rows rectangles of the pixel has one of the samples
/// first .. first + columns * rows - 1.
bool oneInEach(const Camera& camera, const Sampler& sampler, int x, int y, unsigned columns,
               unsigned rows, std::uint32_t first) {
  std::vector<bool> taken(std::size_t{columns} * rows);
  for (std::uint32_t s = first; s < first + columns * rows; ++s) {
    const glm::dvec2 p = placeOf(camera, sampler, x, y, s);
    const auto at =
        static_cast<std::size_t>(p.y * rows) * columns + static_cast<std::size_t>(p.x * columns);
    if (taken.at(at)) return false;
    taken[at] = true;
  }
  return true;
}

TEST(Sobol, EveryAlignedBlockIsANetInEveryPixel) {
  const Camera camera = film(768, 768);
  for (const std::int64_t seed : {0, 1, 77})
    for (int pixel = 0; pixel < 768; pixel += 7)
      for (unsigned k = 1; k <= 8; ++k)
        for (unsigned i = 0; i <= k; ++i)
          for (const std::uint32_t block : {0U, 1U, 5U})
            ASSERT_TRUE(oneInEach(camera, {1U << 20, seed, &samplers::sobol}, pixel, 767 - pixel,
                                  1U << i, 1U << (k - i), block << k))
                << pixel << " k " << k << " i " << i << " block " << block;
}

TEST(Sobol, ALongerRenderBeginsWithTheShorter) {
  const Camera camera = film(70, 45);
  for (std::uint32_t s = 0; s < 100; ++s)
    EXPECT_EQ(samplePosition(camera, {100, 3, &samplers::sobol}, 69, 31, s),
              samplePosition(camera, {1U << 30, 3, &samplers::sobol}, 69, 31, s));
}

TEST(Stratified, OneSampleInEachStratum) {
  // Strata borders other than multiples of 2^-k are not on the grid of samples; on a small film the
  // grid is so fine that no sample here falls between the two.
  const Camera camera = film(2, 2);
  const auto expectStrata = [&](unsigned columns, unsigned rows) {
    EXPECT_EQ(strataOf(columns * rows), glm::uvec2(columns, rows));
    for (int seed = 0; seed < 45; ++seed)
      ASSERT_TRUE(
          oneInEach(camera, {columns * rows, seed, &samplers::stratified}, 1, 0, columns, rows, 0))
          << columns << " x " << rows << " of seed " << seed;
  };
  expectStrata(1, 1);
  expectStrata(2, 4);
  expectStrata(4, 4);
  expectStrata(3, 4);
  expectStrata(1, 13);
  expectStrata(15, 17);
  expectStrata(32, 32);
}

/// By how many standard deviations the chi-squared statistic of equally likely cells exceeds its
/// mean.
double excess(const std::vector<int>& counts, double samples) {
  const double cells = static_cast<double>(counts.size()), expected = samples / cells;
  double chi2 = 0;
  for (const int count : counts) chi2 += std::pow(count - expected, 2) / expected;
  return (chi2 - (cells - 1)) / std::sqrt(2 * (cells - 1));
}

// Bound for some thirty statistics per sampler, all of fixed seeds. Each exceeds 5 with a
// probability of 1e-4 by the chi-squared distribution's tail; constants that mix badly give
// thousands.
constexpr double kBound = 5.0;
constexpr int kSide = 192;
constexpr double kPixels = double{kSide} * kSide;

class Uniform : public testing::TestWithParam<const SamplerRow*> {};

TEST_P(Uniform, EachSampleOverThePixels) {
  const Camera camera = film(kSide, kSide);
  for (const std::int64_t seed : {0, 1, 12345})
    for (const std::uint32_t s : {0U, 1U, 2U, 7U, 15U}) {
      std::vector<int> cells(256), neighbours(256);
      for (int y = 0; y < kSide; ++y) {
        glm::dvec2 before = placeOf(camera, {16, seed, GetParam()}, kSide - 1, y, s);
        for (int x = 0; x < kSide; ++x) {
          const glm::dvec2 p = placeOf(camera, {16, seed, GetParam()}, x, y, s);
          ++cells[static_cast<std::size_t>(p.x * 16) * 16 + static_cast<std::size_t>(p.y * 16)];
          ++neighbours[static_cast<std::size_t>(p.x * 16) * 16 +
                       static_cast<std::size_t>(before.x * 16)];
          before = p;
        }
      }
      EXPECT_LT(excess(cells, kPixels), kBound) << "seed " << seed << " sample " << s;
      EXPECT_LT(excess(neighbours, kPixels), kBound) << "seed " << seed << " sample " << s;
    }
}

TEST_P(Uniform, TwoSamplesWithinTheirStrata) {
  // Of 16 samples one lies in each sixteenth of either axis, which the first four binary digits
  // determine. The positions inside these sixteenths must be independent.
  const Camera camera = film(kSide, kSide);
  for (const auto& [a, b] : {std::pair(0U, 1U), std::pair(0U, 8U), std::pair(5U, 6U)}) {
    std::vector<int> alongX(256), alongY(256);
    const auto inside = [](double place, int strata) {
      return static_cast<std::size_t>((place * strata - std::floor(place * strata)) * 16);
    };
    const int strata = GetParam() == &samplers::sobol ? 16 : 4;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::dvec2 p = placeOf(camera, {16, 0, GetParam()}, x, y, a);
        const glm::dvec2 q = placeOf(camera, {16, 0, GetParam()}, x, y, b);
        ++alongX[inside(p.x, strata) * 16 + inside(q.x, strata)];
        ++alongY[inside(p.y, strata) * 16 + inside(q.y, strata)];
      }
    EXPECT_LT(excess(alongX, kPixels), kBound) << a << " and " << b;
    EXPECT_LT(excess(alongY, kPixels), kBound) << a << " and " << b;
  }
}

TEST_P(Uniform, OtherSeedsAreOtherSamples) {
  const Camera camera = film(kSide, kSide);
  std::vector<int> cells(256);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double p = placeOf(camera, {16, 0, GetParam()}, x, y, 3).x;
      const double q = placeOf(camera, {16, std::int64_t{1} << 32, GetParam()}, x, y, 3).x;
      ++cells[static_cast<std::size_t>(p * 16) * 16 + static_cast<std::size_t>(q * 16)];
    }
  EXPECT_LT(excess(cells, kPixels), kBound);
}

INSTANTIATE_TEST_SUITE_P(Samplers, Uniform,
                         testing::Values(&samplers::stratified, &samplers::sobol));

}  // namespace
}  // namespace laver::test
