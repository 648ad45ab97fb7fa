// The BSDFs' twins in double precision: densities, energy, reciprocity.
#include "scene/bsdfs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reference/bsdf.h"
#include "reference/facets.h"
#include "support/bsdf_cases.h"

namespace laver::test {
namespace {

using reference::BsdfPoint;
using reference::BsdfSample;

constexpr double kPi = std::numbers::pi;
constexpr glm::dvec2 kUv(0.2, 0.5);
constexpr glm::dvec3 kUp(0.0, 0.0, 1.0);

class Bsdfs : public testing::TestWithParam<BsdfCase> {
 protected:
  BsdfPoint point() const { return {bsdf_, kUv, kUp}; }

  /// The square of the ratio of the indices from the side of wo to that of wi.
  double spreadOf(glm::dvec3 wi, glm::dvec3 wo) const {
    if (wi.z * wo.z > 0.0 || !(bsdf_.row->transmissive && !bsdf_.row->properties.empty()))
      return 1.0;
    const double inside = point().real("intIOR"), outside = point().real("extIOR");
    return std::pow(wi.z > 0.0 ? outside / inside : inside / outside, 2.0);
  }

  const Bsdf& bsdf_ = GetParam().bsdf;
};

TEST_P(Bsdfs, ADeltaDistributionHasNoValueAndNoDensity) {
  const glm::dvec3 wi = directionAt(0.7, 1.0), wo = directionAt(0.7, 1.0 + kPi);
  EXPECT_EQ(bsdf_.row->eval(point(), wi, wo) == glm::dvec3(0.0), bsdf_.row->delta);
  EXPECT_EQ(bsdf_.row->pdf(point(), wi, wo) == 0.0, bsdf_.row->delta);
}

// Radiance over the square of the index is what light's way back keeps.
TEST_P(Bsdfs, ValuesAreReciprocal) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 wi = directionAt(kPi * number(engine), 2.0 * kPi * number(engine));
    const glm::dvec3 wo = directionAt(kPi * number(engine), 2.0 * kPi * number(engine));
    const glm::dvec3 there = bsdf_.row->eval(point(), wi, wo);
    const glm::dvec3 back = spreadOf(wi, wo) * bsdf_.row->eval(point(), wo, wi);
    EXPECT_NEAR(glm::length(there - back), 0.0, 1e-9 * (1.0 + glm::length(there)));
  }
}

TEST_P(Bsdfs, BacksAreBlackUnlessLightGoesThrough) {
  if (bsdf_.row->transmissive) return;  // ReflectAndTransmitNoMoreThanArrives
  const glm::dvec3 up = directionAt(0.4, 0.3), down = directionAt(2.5, 0.3);
  EXPECT_EQ(bsdf_.row->eval(point(), up, down), glm::dvec3(0.0));
  EXPECT_EQ(bsdf_.row->eval(point(), down, up), glm::dvec3(0.0));
  EXPECT_EQ(bsdf_.row->eval(point(), down, down), glm::dvec3(0.0));
  EXPECT_EQ(bsdf_.row->sample(point(), down, {0.3, 0.4}).weight, glm::dvec3(0.0));
}

TEST_P(Bsdfs, ASamplesWeightIsTheValueByTheDensity) {
  if (bsdf_.row->delta) return;  // ADeltaDistributionHasNoValueAndNoDensity
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  const glm::dvec3 wi = directionAt(0.8, 0.1);
  int lit = 0;
  for (int i = 0; i < 200; ++i) {
    const BsdfSample s = bsdf_.row->sample(point(), wi, {number(engine), number(engine)});
    if (s.weight == glm::dvec3(0.0)) continue;
    EXPECT_NEAR(glm::length(s.wo), 1.0, 1e-12);
    const double pdf = bsdf_.row->pdf(point(), wi, s.wo);
    const glm::dvec3 weight = bsdf_.row->eval(point(), wi, s.wo) * std::abs(s.wo.z) / pdf;
    EXPECT_NEAR(glm::length(weight - s.weight), 0.0, 1e-9 * glm::length(weight));
    ++lit;
  }
  EXPECT_GT(lit, 100);
}

// A white furnace, from the upper side. Burley's sheen comes on top of the other parts: at grazing
// angles a rough material with half of it gains a ninth.
TEST_P(Bsdfs, ReflectAndTransmitNoMoreThanArrives) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  const bool sheen = std::string_view(bsdf_.row->name) == "disney" && point().real("sheen") > 0.0;
  const double most = sheen ? 1.2 : 1.0 + 1e-12;
  for (const double theta : {0.0, 0.5, 1.0, 1.5}) {
    const glm::dvec3 wi = directionAt(theta, 0.0);
    glm::dvec3 sum(0.0), squares(0.0);
    constexpr int kDrawn = 16384;
    for (int i = 0; i < kDrawn; ++i) {
      const BsdfSample s = bsdf_.row->sample(point(), wi, {number(engine), number(engine)});
      // What is refracted keeps its power: radiance grows as its solid angle shrinks.
      const glm::dvec3 power = s.weight / spreadOf(wi, s.wo);
      sum += power;
      squares += power * power;
    }
    const glm::dvec3 mean = sum / static_cast<double>(kDrawn);
    const glm::dvec3 variance = squares / static_cast<double>(kDrawn) - mean * mean;
    for (int c = 0; c < 3; ++c)
      EXPECT_LE(mean[c], most + 4.0 * std::sqrt(std::max(variance[c], 0.0) / kDrawn)) << theta;
  }
}

// What is refracted keeps its power: radiance grows as its solid angle shrinks.
TEST_P(Bsdfs, SmoothGlassMirrorsAndNothingLoseNoLight) {
  const std::string name = bsdf_.row->name;
  if (name != "mirror" && name != "dielectric" && name != "null") return;  // others absorb
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 wi = directionAt(0.5 * kPi * number(engine), 0.3);
    const BsdfSample s = bsdf_.row->sample(point(), wi, {number(engine), number(engine)});
    EXPECT_NEAR(glm::length(s.weight / spreadOf(wi, s.wo) - glm::dvec3(1.0)), 0.0, 1e-12);
  }
}

TEST_P(Bsdfs, DensitiesAreThoseOfTheSamples) {
  if (bsdf_.row->delta) return;  // ADeltaDistributionHasNoValueAndNoDensity
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (const double theta : {0.6, 1.3, 2.4}) {
    if (theta > 0.5 * kPi && !bsdf_.row->transmissive) continue;
    const glm::dvec3 wi = directionAt(theta, 0.4);
    std::vector<glm::dvec3> samples(65536);
    for (glm::dvec3& wo : samples) {
      const BsdfSample s = bsdf_.row->sample(point(), wi, {number(engine), number(engine)});
      wo = s.weight == glm::dvec3(0.0) ? glm::dvec3(0.0) : s.wo;
    }
    EXPECT_LT(deviateOf(bsdf_, kUv, wi, samples), 4.0) << theta;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Bsdfs, testing::ValuesIn(bsdfCases()), nameOf);

/// The share of light from everywhere that is reflected, and the variance of single samples, both
/// as luminance, by 512 x 512 strata of the numbers.
struct Reflected {
  double mean = 0.0, variance = 0.0;
};
Reflected reflectedBy(const Bsdf& bsdf, double theta) {
  const BsdfPoint point(bsdf, kUv, kUp);
  constexpr int kSide = 512;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const glm::dvec2 numbers((i + 0.5) / kSide, (j + 0.5) / kSide);
      const double y =
          reference::luminance(bsdf.row->sample(point, directionAt(theta, 0.0), numbers).weight);
      sum += y;
      squares += y * y;
    }
  const double mean = sum / (kSide * kSide);
  return {mean, squares / (kSide * kSide) - mean * mean};
}

// The courses' own test takes 100,000 samples. Three of their standard errors.
TEST(Microfacet, ReflectsWhatTheCoursesTestSays) {
  Bsdf bsdf{.row = rowCalled(bsdfRows(), "microfacet")};
  bsdf.set("intIOR", 1.5);
  bsdf.set("kd", glm::dvec3(0.1, 0.2, 0.15));
  const double angles[] = {0.0, 45.0, 60.0, 80.0, 85.0};
  const double wanted[] = {0.207067, 0.215733, 0.247884, 0.430936, 0.519016};
  for (int i = 0; i < 5; ++i) {
    const Reflected got = reflectedBy(bsdf, angles[i] * kPi / 180.0);
    EXPECT_NEAR(got.mean, wanted[i], 3.0 * std::sqrt(got.variance / 1e5)) << angles[i];
  }
}

TEST(Fresnel, OfGlassHeadOnAndAtTheLimit) {
  EXPECT_NEAR(reference::fresnel(1.0, 1.000277, 1.5046), 0.0405, 5e-5);
  EXPECT_EQ(reference::fresnel(0.3, 1.3, 1.3), 0.0);
  EXPECT_EQ(reference::fresnel(-0.1, 1.0, 1.5), 1.0);  // total reflection
}

TEST(Fresnel, OfConductorsHeadOn) {
  const glm::dvec3 eta(0.2, 1.0, 4.0), k(3.0, 0.0, 2.0);
  const glm::dvec3 f = reference::conductorFresnel(1.0, eta, k);
  for (int c = 0; c < 3; ++c) {
    const double k2 = k[c] * k[c];
    EXPECT_NEAR(f[c], (std::pow(eta[c] - 1.0, 2.0) + k2) / (std::pow(eta[c] + 1.0, 2.0) + k2),
                1e-14);
  }
}

}  // namespace
}  // namespace laver::test
