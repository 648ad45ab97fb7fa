// The stream of pairs of each sampler: uniform, and independent between dimensions.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/pcg32.h"
#include "reference/sampler.h"

namespace laver::reference {
namespace {

constexpr int kSide = 192;
constexpr int kCells = 16;

Camera film() {
  Camera camera;
  camera.width = camera.height = kSide;
  return camera;
}

std::size_t cellOf(double x, double y) {
  return static_cast<std::size_t>(x * kCells) * kCells + static_cast<std::size_t>(y * kCells);
}

/// By how many standard deviations the chi-squared statistic of equally likely cells exceeds its
/// mean.
double excess(const std::vector<int>& counts) {
  double sum = 0, chi2 = 0;
  for (const int count : counts) sum += count;
  const double cells = static_cast<double>(counts.size()), expected = sum / cells;
  for (const int count : counts) chi2 += std::pow(count - expected, 2) / expected;
  return (chi2 - (cells - 1)) / std::sqrt(2 * (cells - 1));
}

// Bound for 60 statistics of fixed seeds. Each exceeds 5 with a probability of 1e-4 by the
// chi-squared distribution's tail; dependent dimensions give hundreds.
constexpr double kBound = 5.0;

class SamplerNumbers : public testing::TestWithParam<const SamplerRow*> {
 protected:
  const Camera camera_ = film();
  const Sampler sampler_{16, 3, GetParam()};

  glm::dvec2 pair(int x, int y, std::uint32_t sample, std::uint32_t dimension) const {
    return Numbers(camera_, sampler_, {x, y, sample}).pair(dimension);
  }
};

TEST_P(SamplerNumbers, AreUniformInEachDimension) {
  for (const std::uint32_t dimension : {1U, 2U, 3U, 7U, 60U}) {
    std::vector<int> cells(kCells * kCells);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::dvec2 p = pair(x, y, 5, dimension);
        ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0);
        ++cells[cellOf(p.x, p.y)];
      }
    EXPECT_LT(excess(cells), kBound) << dimension;
  }
}

TEST_P(SamplerNumbers, OfTwoDimensionsAreIndependent) {
  for (const auto& [a, b] : {std::pair(1U, 2U), std::pair(2U, 3U), std::pair(1U, 3U),
                             std::pair(2U, 7U), std::pair(6U, 7U)}) {
    std::vector<int> first(kCells * kCells), second(kCells * kCells);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const auto sample = static_cast<std::uint32_t>(x + y) % 16;
        const glm::dvec2 p = pair(x, y, sample, a), q = pair(x, y, sample, b);
        ++first[cellOf(p.x, q.x)];
        ++second[cellOf(p.y, q.y)];
      }
    EXPECT_LT(excess(first), kBound) << a << " and " << b;
    EXPECT_LT(excess(second), kBound) << a << " and " << b;
  }
}

TEST_P(SamplerNumbers, ChangeWithTheSeed) {
  Sampler other = sampler_;
  other.seed += std::int64_t{1} << 32;
  for (const std::uint32_t dimension : {1U, 2U, 9U})
    EXPECT_NE(pair(7, 9, 2, dimension), Numbers(camera_, other, {7, 9, 2}).pair(dimension));
}

INSTANTIATE_TEST_SUITE_P(Samplers, SamplerNumbers,
                         testing::Values(&samplers::independent, &samplers::stratified,
                                         &samplers::sobol));

TEST(SamplerNumbersOf, IndependentContinueNorisStreamAfterTheFilmPosition) {
  const Camera camera = film();
  const Sampler sampler{3, -5, &samplers::independent};
  const auto seed = static_cast<std::uint64_t>(sampler.seed);
  Pcg32 random(32 + seed, 64 + seed);
  // In the block from (32, 64): pixel (1, 2), sample 1, its third and fourth number.
  random.advance(4 * ((2 * 32 + 1) * 3 + 1) + 2);
  const float v = random.nextFloat(), u = random.nextFloat();
  EXPECT_EQ(Numbers(camera, sampler, {33, 66, 1}).pair(1), glm::dvec2(glm::vec2(u, v)));
}

TEST(SamplerNumbersOf, SobolAreNetsInEachDimension) {
  const Camera camera = film();
  const Sampler sampler{64, 1, &samplers::sobol};
  for (std::uint32_t dimension = 1; dimension < 12; ++dimension)
    for (unsigned k = 1; k <= 6; ++k)
      for (unsigned i = 0; i <= k; ++i) {
        std::vector<bool> taken(std::size_t{1} << k);
        for (std::uint32_t s = 0; s < 1U << k; ++s) {
          const glm::dvec2 p = Numbers(camera, sampler, {11, 5, s}).pair(dimension);
          const auto cell = (static_cast<std::size_t>(p.x * (1U << i)) << (k - i)) +
                            static_cast<std::size_t>(p.y * (1U << (k - i)));
          ASSERT_FALSE(taken.at(cell)) << dimension << ' ' << k << ' ' << i;
          taken[cell] = true;
        }
      }
}

TEST(SamplerNumbersOf, APairMayReplaceTheStream) {
  const Numbers numbers(glm::dvec2(0.25, 0.75));
  EXPECT_EQ(numbers.pair(1), glm::dvec2(0.25, 0.75));
  EXPECT_EQ(numbers.pair(9), glm::dvec2(0.25, 0.75));
}

}  // namespace
}  // namespace laver::reference
