#include "core/numeric.h"

#include <gtest/gtest.h>

namespace laver::test {
namespace {

TEST(Numeric, UlpsAreRelativeToTheTruth) {
  EXPECT_EQ(ulpOf(1.0), 0x1p-23);
  EXPECT_EQ(ulpOf(-1.5), 0x1p-23);
  EXPECT_EQ(ulpOf(2.0), 0x1p-22);
  EXPECT_EQ(ulpOf(0.0), 0x1p-149);
  EXPECT_EQ(ulps(1.0F, 1.0 + 0x1p-24), 0.5);
  EXPECT_EQ(ulps(-2.0F, -1.0), 0x1p23);
}

TEST(Numeric, TheMaximumNormIgnoresSigns) {
  EXPECT_EQ(maxNorm({1.0, -3.0, 2.0}), 3.0);
  EXPECT_EQ(maxNorm({0.0, 0.0, 0.0}), 0.0);
}

TEST(Numeric, PercentilesAreOneOfTheValues) {
  EXPECT_EQ(percentile({}, 0.5), 0.0);
  EXPECT_EQ(percentile({7.0}, 0.01), 7.0);
  EXPECT_EQ(percentile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(percentile({4.0, 1.0, 3.0, 2.0}, 0.51), 3.0);
  EXPECT_EQ(percentile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
}

TEST(Numeric, QuantilesLieBetweenRanks) {
  EXPECT_EQ(quantile({}, 0.5), 0.0);
  EXPECT_EQ(quantile({7.0}, 0.25), 7.0);
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.25), 1.75);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
}

}  // namespace
}  // namespace laver::test
