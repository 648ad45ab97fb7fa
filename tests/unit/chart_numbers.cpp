// The axes of a chart.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lab/chart/numbers.h"

namespace laver::test {
namespace {

using namespace chart;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(ChartNumbers, AxesHoldTheirValuesAndHaveTicks) {
  const double values[] = {0.02, 0.5, 0.0, kNaN, 40.0};
  const LogAxis axis = axisAround(values);
  EXPECT_LT(axis.low, 0.02);
  EXPECT_GT(axis.high, 40.0);
  EXPECT_GT(axis.at(0.02), 0.0);
  EXPECT_LT(axis.at(40.0), 1.0);
  EXPECT_NEAR(axis.at(std::sqrt(axis.low * axis.high)), 0.5, 1e-12);
  EXPECT_EQ(axis.ticks(), (std::vector<double>{0.1, 1.0, 10.0}));
  EXPECT_EQ((LogAxis{0.9, 11.0}.ticks()), (std::vector<double>{1.0, 2.0, 5.0, 10.0}));
  EXPECT_EQ((LogAxis{1.7, 4.2}.ticks()), (std::vector<double>{2.0, 3.0, 4.0}));
  EXPECT_EQ((LogAxis{1.1, 1.7}.ticks()), (std::vector<double>{1.2, 1.4, 1.6}));
  EXPECT_EQ((LogAxis{6.1, 9.6}.ticks()), (std::vector<double>{7.0, 8.0, 9.0}));
  EXPECT_LT(axisAround({}).low, axisAround({}).high);
}

}  // namespace
}  // namespace laver::test
