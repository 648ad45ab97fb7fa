// The reference's BSDFs: densities, energy, reciprocity.
#include "scene/bsdfs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reference/bsdf.h"

namespace laver::test {
namespace {

using reference::BsdfPoint;
using reference::BsdfSample;

constexpr double kPi = std::numbers::pi;

glm::dvec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

class Bsdfs : public testing::TestWithParam<const BsdfRow*> {
 protected:
  Bsdfs() { bsdf_.row = GetParam(); }
  BsdfPoint point() const { return {bsdf_, {0.2, 0.5, 0.9}, {0.0, 0.0, 1.0}}; }
  Bsdf bsdf_;
};

TEST_P(Bsdfs, ADeltaDistributionHasNoValueAndNoDensity) {
  const glm::dvec3 wi = direction(0.7, 1.0), wo = direction(0.7, 1.0 + kPi);
  EXPECT_EQ(bsdf_.row->eval(point(), wi, wo) == glm::dvec3(0.0), bsdf_.row->delta);
  EXPECT_EQ(bsdf_.row->pdf(point(), wi, wo) == 0.0, bsdf_.row->delta);
}

TEST_P(Bsdfs, ValuesAreReciprocal) {
  const glm::dvec3 wi = direction(0.3, 0.2), wo = direction(1.2, 2.0);
  EXPECT_EQ(bsdf_.row->eval(point(), wi, wo), bsdf_.row->eval(point(), wo, wi));
}

TEST_P(Bsdfs, ReflectNoMoreThanArrives) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (const double theta : {0.0, 0.5, 1.0, 1.5}) {
    glm::dvec3 sum(0.0);
    constexpr int kDrawn = 4096;
    for (int i = 0; i < kDrawn; ++i) {
      const BsdfSample sample =
          bsdf_.row->sample(point(), direction(theta, 0.0), {number(engine), number(engine)});
      EXPECT_NEAR(glm::length(sample.wo), 1.0, 1e-12);
      // Refracted light keeps its power: radiance grows as its solid angle shrinks.
      sum += sample.wo.z > 0.0 ? sample.weight : glm::dvec3(1.0);
    }
    EXPECT_LE(std::max({sum.x, sum.y, sum.z}), kDrawn * (1.0 + 1e-12)) << theta;
  }
}

TEST_P(Bsdfs, DensitiesMatchTheSamples) {
  if (bsdf_.row->delta) return;  // ADeltaDistributionHasNoValueAndNoDensity
  // Chi-squared over 8 x 8 cells of equal solid angle, 63 degrees of freedom: one seed in 4000
  // exceeds 110 by chance.
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  constexpr int kCells = 8, kDrawn = 65536;
  const glm::dvec3 wi = direction(0.6, 0.4);
  std::array<double, kCells * kCells> seen{}, expected{};
  for (int i = 0; i < kDrawn; ++i) {
    const glm::dvec3 wo = bsdf_.row->sample(point(), wi, {number(engine), number(engine)}).wo;
    const int row = std::min(static_cast<int>(wo.z * kCells), kCells - 1);
    const double turn = std::atan2(wo.y, wo.x) / (2.0 * kPi) + 0.5;
    const int column = std::min(static_cast<int>(turn * kCells), kCells - 1);
    ++seen[static_cast<std::size_t>(row * kCells + column)];
  }
  constexpr int kSteps = 16;  // of the midpoint rule, per side
  for (int row = 0; row < kCells * kSteps; ++row)
    for (int column = 0; column < kCells * kSteps; ++column) {
      const double z = (row + 0.5) / (kCells * kSteps);
      const double phi = ((column + 0.5) / (kCells * kSteps) - 0.5) * 2.0 * kPi;
      const double share = 2.0 * kPi / (kCells * kSteps * kCells * kSteps);
      expected[static_cast<std::size_t>(row / kSteps * kCells + column / kSteps)] +=
          bsdf_.row->pdf(point(), wi, direction(std::acos(z), phi)) * share * kDrawn;
    }
  double chi = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i)
    chi += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
  EXPECT_LT(chi, 110.0);
}

INSTANTIATE_TEST_SUITE_P(Rows, Bsdfs, testing::ValuesIn(bsdfRows()),
                         [](const auto& instance) { return std::string(instance.param->name); });

TEST(Fresnel, OfGlassAtNormalIncidenceAndAtTheCriticalAngle) {
  EXPECT_NEAR(reference::fresnel(1.0, 1.000277, 1.5046), 0.0405, 5e-5);
  EXPECT_EQ(reference::fresnel(0.3, 1.3, 1.3), 0.0);
  EXPECT_EQ(reference::fresnel(-0.1, 1.0, 1.5), 1.0);  // total reflection
}

}  // namespace
}  // namespace laver::test
