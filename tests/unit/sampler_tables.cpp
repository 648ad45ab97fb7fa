#include <gtest/gtest.h>

#include "render/pack_parts.h"

namespace laver::test {
namespace {

constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;

TEST(SamplerTables, AJumpEqualsItsSteps) {
  const std::uint64_t start = 0x0123456789abcdefULL, inc = (54ULL << 1) | 1;
  std::uint64_t state = start;
  for (std::uint64_t steps = 0; steps < 5000; ++steps) {
    const PcgJump jump = pcgJump(steps);
    ASSERT_EQ(jump.multiplier * start + jump.increments * inc, state) << steps;
    state = state * kMultiplier + inc;
  }
}

TEST(SamplerTables, JumpsAdd) {
  const PcgJump a = pcgJump(123456789012345ULL), b = pcgJump(987654321ULL);
  const PcgJump both = pcgJump(123456789012345ULL + 987654321ULL);
  EXPECT_EQ(b.multiplier * a.multiplier, both.multiplier);
  EXPECT_EQ(b.multiplier * a.increments + b.increments, both.increments);
}

std::uint64_t join(glm::uvec2 halves) {
  return static_cast<std::uint64_t>(halves.y) << 32 | halves.x;
}

/// Steps that the tables jump for a pixel of a block and a sample.
PcgJump lookUp(const Packed& data, std::uint32_t levels, std::uint32_t pixel,
               std::uint32_t number) {
  const auto entry = [&](std::size_t i) {
    return PcgJump{join(data.jumps.at(i).multiplier), join(data.jumps.at(i).increments)};
  };
  PcgJump jump = entry(pixel);
  const auto follow = [&](std::size_t i) {
    const PcgJump next = entry(i);
    jump = {next.multiplier * jump.multiplier, next.multiplier * jump.increments + next.increments};
  };
  if (levels == 2) follow(data.params.samplerArguments.x + number);
  if (levels == 3) {
    follow(data.params.samplerArguments.x + number % data.params.samplerArguments.z);
    follow(data.params.samplerArguments.y + number / data.params.samplerArguments.z);
  }
  return jump;
}

TEST(SamplerTables, EveryLevelReachesTheSamplesOwnNumber) {
  for (const std::uint32_t samples : {1U, 7U, 1024U, 1025U, 65536U}) {
    Scene scene;
    scene.sampler.sampleCount = samples;
    Packed data;
    const std::uint32_t levels = jumpLevels(samples);
    EXPECT_EQ(levels, samples <= 1024 ? 2U : 3U);
    packSampler(scene, levels, data);
    for (const std::uint32_t pixel : {0U, 1U, 500U, 1023U})
      for (const std::uint32_t number : {0U, samples / 2, samples - 1}) {
        const PcgJump wanted =
            pcgJump(4ULL * (static_cast<std::uint64_t>(pixel) * samples + number) + 1);
        const PcgJump got = lookUp(data, levels, pixel, number);
        EXPECT_EQ(got.multiplier, wanted.multiplier);
        EXPECT_EQ(got.increments, wanted.increments);
      }
  }
}

}  // namespace
}  // namespace laver::test
