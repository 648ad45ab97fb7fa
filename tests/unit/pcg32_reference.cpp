#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "reference/pcg32.h"
#include "reference/sampler.h"

namespace laver::test {
namespace {

using namespace reference;

TEST(ReferencePcg32, PublishedVector) {
  // First round of pcg32-demo, seed 42, sequence 54.
  Pcg32 random(42, 54);
  for (const std::uint32_t expected :
       {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu}) {
    EXPECT_EQ(random.next(), expected);
  }
}

TEST(ReferencePcg32, AdvanceEqualsStepping) {
  for (const std::uint64_t count : {0u, 1u, 2u, 3u, 7u, 64u, 1000u, 4097u}) {
    Pcg32 stepped(7, 11), jumped(7, 11);
    for (std::uint64_t i = 0; i < count; ++i) stepped.next();
    jumped.advance(count);
    EXPECT_EQ(stepped.next(), jumped.next()) << count;
  }
}

TEST(ReferencePcg32, AdvanceBeyond32BitsAddsUp) {
  Pcg32 once(7, 11), twice(7, 11);
  once.advance((1ull << 40) + 12345);
  twice.advance(1ull << 40);
  twice.advance(12345);
  EXPECT_EQ(once.next(), twice.next());
}

TEST(ReferencePcg32, FloatsAreTheTop23Bits) {
  Pcg32 bits(42, 54), floats(42, 54);
  for (int i = 0; i < 1000; ++i) {
    const float value = floats.nextFloat();
    EXPECT_EQ(static_cast<double>(value), static_cast<double>(bits.next() >> 9) / (1 << 23));
  }
}

// Draws a film's samples one after the other, block by block.
std::map<std::pair<int, int>, std::vector<glm::vec2>> drawInOrder(const Camera& camera,
                                                                  const Sampler& sampler) {
  std::map<std::pair<int, int>, std::vector<glm::vec2>> positions;
  for (int top = 0; top < camera.height; top += 32) {
    for (int left = 0; left < camera.width; left += 32) {
      Pcg32 random(static_cast<std::uint64_t>(left + sampler.seed),
                   static_cast<std::uint64_t>(top + sampler.seed));
      for (int y = top; y < top + 32 && y < camera.height; ++y) {
        for (int x = left; x < left + 32 && x < camera.width; ++x) {
          for (std::uint32_t s = 0; s < sampler.sampleCount; ++s) {
            const float first = random.nextFloat(), second = random.nextFloat();
            random.next();
            random.next();
            positions[{x, y}].push_back(
                {static_cast<float>(x) + second, static_cast<float>(y) + first});
          }
        }
      }
    }
  }
  return positions;
}

class ReferenceSampler : public testing::TestWithParam<std::int64_t> {};

TEST_P(ReferenceSampler, EqualsDrawingInOrder) {
  Camera camera;
  camera.width = 70;
  camera.height = 45;
  const Sampler sampler{3, GetParam()};
  for (const auto& [pixel, positions] : drawInOrder(camera, sampler)) {
    for (std::uint32_t s = 0; s < sampler.sampleCount; ++s) {
      EXPECT_EQ(samplePosition(camera, sampler, pixel.first, pixel.second, s), positions[s])
          << pixel.first << ' ' << pixel.second << ' ' << s;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReferenceSampler, testing::Values(0, 1, -5, std::int64_t{1} << 40));

}  // namespace
}  // namespace laver::test
