// The arithmetic of a chart.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lab/chart/numbers.h"

namespace laver::chart {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(ChartNumbers, TheFrontHoldsWhatNoOtherBeats) {
  const Place places[] = {{3, 1}, {1, 3}, {2, 3}, {2, 2}, {2, 2}, {4, 1}, {kNaN, 0}, {0.5, kNaN}};
  EXPECT_EQ(paretoFront(places), (std::vector<std::size_t>{1, 3, 0}));
  EXPECT_TRUE(paretoFront({}).empty());
}

TEST(ChartNumbers, SlopesAreThoseOfPowers) {
  std::vector<Place> places;
  for (const double x : {1.0, 4.0, 16.0, 64.0}) places.push_back({x, 0.3 * std::pow(x, -0.75)});
  EXPECT_NEAR(logSlope(places), -0.75, 1e-12);
  places.push_back({0.0, 1.0});  // has no logarithm
  EXPECT_NEAR(logSlope(places), -0.75, 1e-12);
  EXPECT_TRUE(std::isnan(logSlope(std::vector<Place>{{1, 1}})));
  EXPECT_TRUE(std::isnan(logSlope(std::vector<Place>{{2, 1}, {2, 3}})));
}

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
}  // namespace laver::chart
