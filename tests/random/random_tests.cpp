// Random scenes by the device and by the reference: whatever differs is explained.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>

#include "random/verdict.h"

namespace laver::test {
namespace {

/// Seeds from `begin` on. What is refused is counted, and may not be much.
void expectPassed(std::uint64_t begin, std::uint64_t count) {
  std::optional<Court> court;
  std::uint64_t refused = 0;
  for (std::uint64_t seed = begin; seed < begin + count; ++seed) {
    // Kernels of other kinds are forgotten.
    if (!court || seed % kBlock == 0) court.emplace();
    const RandomScene random = randomScene(seed);
    const Verdict verdict = court->judge(random);
    refused += verdict.result == Verdict::Result::Refused ? 1 : 0;
    EXPECT_FALSE(verdict.failed()) << "seed " << seed << ": " << verdict.why << "\n"
                                   << random.traits;
  }
  testing::Test::RecordProperty("refused", static_cast<int>(refused));
  EXPECT_LE(refused, count / 20);
}

class RandomScenes : public testing::TestWithParam<std::uint64_t> {};

/// Without a difference that rounding does not explain, a crash, or a value that is not finite.
TEST_P(RandomScenes, AreThoseOfTheReference) { expectPassed(100 * GetParam(), 100); }

INSTANTIATE_TEST_SUITE_P(Hundred, RandomScenes, testing::Range<std::uint64_t>(0, 10));

class FullRandomScenes : public testing::TestWithParam<std::uint64_t> {};

TEST_P(FullRandomScenes, AreThoseOfTheReference) { expectPassed(10000 * GetParam(), 10000); }

INSTANTIATE_TEST_SUITE_P(TenThousand, FullRandomScenes, testing::Range<std::uint64_t>(0, 10));

}  // namespace
}  // namespace laver::test
