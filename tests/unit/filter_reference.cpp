#include <gtest/gtest.h>

#include <cmath>

#include "reference/filter.h"

namespace laver::test {
namespace {

using namespace reference;

Filter filterOf(const FilterRow* kind, double radius) {
  Filter filter;
  filter.row = kind;
  filter.radius = radius;
  return filter;
}

TEST(ReferenceFilter, Gaussian) {
  const FilterWeights weights(Filter{}, false);
  EXPECT_NEAR(weights(0.0), 1.0 - std::exp(-8.0), 1e-15);
  EXPECT_NEAR(weights(1.0), std::exp(-2.0) - std::exp(-8.0), 1e-15);
  EXPECT_NEAR(weights(-1.0), std::exp(-2.0) - std::exp(-8.0), 1e-15);
  EXPECT_EQ(weights(2.0), 0.0);
  EXPECT_EQ(weights(2.5), 0.0);
}

TEST(ReferenceFilter, GaussianOfAnotherWidth) {
  Filter filter = filterOf(&filters::gaussian, 3.0);
  filter.stddev = 1.0;
  EXPECT_NEAR(FilterWeights(filter, false)(2.0), std::exp(-2.0) - std::exp(-4.5), 1e-15);
}

TEST(ReferenceFilter, Mitchell) {
  const FilterWeights weights(filterOf(&filters::mitchell, 2.0), false);
  EXPECT_NEAR(weights(0.0), 8.0 / 9.0, 1e-15);
  EXPECT_NEAR(weights(1.0), 1.0 / 18.0, 1e-15);
  EXPECT_NEAR(weights(1.5), -5.0 / 144.0, 1e-15);
  EXPECT_EQ(weights(2.0), 0.0);
  for (const double x : {0.0, 0.1, 0.37, 0.5, 0.99}) {
    EXPECT_NEAR(weights(x) + weights(x - 1) + weights(x + 1) + weights(x - 2), 1.0, 1e-14) << x;
  }
}

TEST(ReferenceFilter, MitchellStretchesOverTheRadius) {
  const FilterWeights weights(filterOf(&filters::mitchell, 4.0), false);
  EXPECT_NEAR(weights(2.0), 1.0 / 18.0, 1e-15);
}

TEST(ReferenceFilter, MitchellParameters) {
  Filter filter = filterOf(&filters::mitchell, 2.0);
  filter.B = 0.0;  // Catmull-Rom: 1 at 0, 0 at 1
  filter.C = 0.5;
  const FilterWeights weights(filter, false);
  EXPECT_NEAR(weights(0.0), 1.0, 1e-15);
  EXPECT_NEAR(weights(1.0), 0.0, 1e-15);
  EXPECT_NEAR(weights(1.5), -0.0625, 1e-15);
}

TEST(ReferenceFilter, Tent) {
  const FilterWeights weights(filterOf(&filters::tent, 2.0), false);
  EXPECT_EQ(weights(0.0), 1.0);
  EXPECT_EQ(weights(-0.5), 0.75);
  EXPECT_EQ(weights(2.0), 0.0);
}

TEST(ReferenceFilter, BoxIncludesItsBorder) {
  const FilterWeights weights(filterOf(&filters::box, 0.5), false);
  EXPECT_EQ(weights(0.0), 1.0);
  EXPECT_EQ(weights(0.5), 1.0);
  EXPECT_EQ(weights(-0.5), 1.0);
  EXPECT_EQ(weights(0.5 + 1e-15), 0.0);
}

TEST(ReferenceFilter, ReachCoversEverySampleWithinTheRadius) {
  EXPECT_EQ(FilterWeights(filterOf(&filters::gaussian, 2.0), false).reach(), 2);
  EXPECT_EQ(FilterWeights(filterOf(&filters::tent, 1.0), false).reach(), 1);
  EXPECT_EQ(FilterWeights(filterOf(&filters::box, 0.5), false).reach(), 1);
  EXPECT_EQ(FilterWeights(filterOf(&filters::gaussian, 2.5), false).reach(), 3);
}

TEST(ReferenceFilter, TableFloors) {
  const FilterWeights exact(Filter{}, false), table(Filter{}, true);
  const double step = 2.0 / 32;
  for (int i = 0; i < 32; ++i) {
    EXPECT_NEAR(table(i * step), exact(i * step), 1e-7) << i;
    EXPECT_EQ(table((i + 0.9) * step), table(i * step)) << i;
    EXPECT_EQ(table(-(i + 0.9) * step), table(i * step)) << i;
  }
  EXPECT_NE(table(0.9 * step), table(step));
}

TEST(ReferenceFilter, TableIndexIsComputedInFloat) {
  const FilterWeights table(Filter{}, true);
  EXPECT_EQ(table(0.0625 - 1e-12), table(0.0625));
  EXPECT_NE(table(0.0625 - 1e-6), table(0.0625));
}

TEST(ReferenceFilter, LastEntryOfTheTableIsZero) {
  const FilterWeights table(filterOf(&filters::box, 0.5), true);
  EXPECT_EQ(table(0.5), 0.0);
  EXPECT_EQ(table(0.499), 1.0);
}

}  // namespace
}  // namespace laver::test
