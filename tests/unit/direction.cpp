// The kernels' directions on a hemisphere, compiled as C++ from the same text.
#include "shared/direction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace laver::test {
namespace {

using namespace shared;

TEST(Direction, CosinesAndSinesOfTurns) {
  double worst = 0;
  for (int i = 0; i <= 100000; ++i) {
    const float x = static_cast<float>(i) / 100000.0F;
    const vec2 got = cosSinOfTurn(x);
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(x);
    worst = std::max({worst, std::abs(static_cast<double>(got.x) - std::cos(angle)),
                      std::abs(static_cast<double>(got.y) - std::sin(angle))});
  }
  EXPECT_LT(worst, 2e-7);  // as direction.h promises
}

constexpr int kSide = 512;
vec2 numbers(int i, int j) {
  return (vec2(static_cast<float>(i), static_cast<float>(j)) + 0.5F) / static_cast<float>(kSide);
}

/// Checks the mean direction of a hemisphere around `normal` and the mean square of its cosine.
template <class Direction>
void expectMoments(vec3 normal, const Direction& direction, double mean, double square) {
  glm::dvec3 sum(0.0);
  double squares = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const glm::dvec3 d(direction(normal, numbers(i, j)));
      ASSERT_NEAR(glm::length(d), 1.0, 1e-6);
      const double cosine = glm::dot(d, glm::dvec3(normal));
      ASSERT_GE(cosine, -1e-6);
      sum += d;
      squares += cosine * cosine;
    }
  const double count = kSide * kSide;
  // Midpoints of the grid miss the mean by the square of the step, 4e-6, and a little more at the
  // edge.
  EXPECT_LT(glm::length(sum / count - mean * glm::dvec3(normal)), 5e-5);
  EXPECT_NEAR(squares / count, square, 5e-5);
}

const vec3 kNormals[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.48F, -0.6F, 0.64F}};

TEST(Direction, UniformHemisphereHasItsMoments) {
  for (const vec3 n : kNormals) expectMoments(n, uniformDirection, 0.5, 1.0 / 3.0);
}

TEST(Direction, CosineHemisphereHasItsMoments) {
  for (const vec3 n : kNormals) expectMoments(n, cosineDirection, 2.0 / 3.0, 0.5);
}

TEST(Direction, IsContinuousInTheNormal) {
  // Within an ulp of an axis on all sides, where tangent frames would jump.
  for (const float e : {-1e-7F, 0.0F, 1e-7F})
    for (int i = 0; i < kSide; i += 7)
      for (int j = 0; j < kSide; j += 7) {
        const vec3 n(0, 0, 1), m(e, -e, 1);
        const vec2 x = numbers(i, j);
        EXPECT_LT(glm::length(uniformDirection(n, x) - uniformDirection(m, x)), 2e-6F);
        // n + w may be as short as 2 sqrt(1 - x.x) > 0.06, which magnifies.
        EXPECT_LT(glm::length(cosineDirection(n, x) - cosineDirection(m, x)), 2e-5F);
      }
}

}  // namespace
}  // namespace laver::test
