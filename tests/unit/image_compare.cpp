#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "image/compare.h"
#include "support/expect_error.h"
#include "unit/images.h"

namespace laver::test {
namespace {

ChannelDifference compareOne(std::vector<float> a, std::vector<float> b, double tolerance) {
  return compare(row({"Y"}, std::move(a)), row({"Y"}, std::move(b)), tolerance).at(0);
}

TEST(Compare, MatchesValuesComputedByHand) {
  // Differences 0, 3, -4, 0 against references 1, 1, 10, 0.
  const ChannelDifference d = compareOne({1, 4, 6, 0}, {1, 1, 10, 0}, 3.0);
  EXPECT_EQ(d.channel, "Y");
  EXPECT_DOUBLE_EQ(d.rmse, 2.5);  // sqrt(25 / 4)
  EXPECT_DOUBLE_EQ(d.relativeMse, (9.0 / 1.01 + 16.0 / 100.01) / 4.0);
  EXPECT_EQ(d.distances.maximum, 4.0);
  EXPECT_EQ(d.distances.percentile999, 4.0);
  EXPECT_EQ(d.distances.share, 0.25);  // 3 does not exceed 3
}

TEST(Compare, IsExactInDouble) {
  const ChannelDifference d = compareOne({1.0f, 3e38f}, {std::nextafter(1.0f, 2.0f), -3e38f}, 0.0);
  EXPECT_DOUBLE_EQ(d.distances.maximum, 2.0 * static_cast<double>(3e38f));
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(2.0) * static_cast<double>(3e38f));
  EXPECT_EQ(d.distances.share, 1.0);
  EXPECT_EQ(compareOne({1.0f}, {std::nextafter(1.0f, 2.0f)}, 0.0).distances.maximum, 0x1p-23);
}

TEST(Compare, TakesTheNearestRankAsPercentile) {
  // Differences 1 .. n in a shuffled order: rank ceil(0.999 n).
  const auto percentile = [](unsigned n) {
    std::vector<float> a;
    for (unsigned i = 0; i < n; ++i) a.push_back(static_cast<float>((i * 7919u) % n + 1u));
    return compareOne(a, std::vector<float>(n, 0.0f), 0.0).distances.percentile999;
  };
  EXPECT_EQ(percentile(1), 1.0);
  EXPECT_EQ(percentile(999), 999.0);
  EXPECT_EQ(percentile(1000), 999.0);
  EXPECT_EQ(percentile(1001), 1000.0);
  EXPECT_EQ(percentile(2000), 1998.0);
}

TEST(Compare, HasMeanAndPercentiles) {
  std::vector<double> numbers;
  for (int i = 1; i <= 200; ++i) numbers.push_back(i);
  const Distribution d = distributionOf(numbers, 150.0);
  EXPECT_DOUBLE_EQ(d.mean, 100.5);
  EXPECT_EQ(d.median, 100.0);
  EXPECT_EQ(d.percentile95, 190.0);
  EXPECT_EQ(d.percentile99, 198.0);
  EXPECT_EQ(d.percentile999, 200.0);
  EXPECT_DOUBLE_EQ(d.share, 0.25);
}

TEST(Compare, MatchesChannelsByName) {
  const Image a = row({"R", "G", "B"}, {1, 2, 3, 4, 5, 6});
  const Image b = row({"B", "G", "R"}, {3, 2, 1, 6, 5.5f, 4});
  const std::vector<ChannelDifference> d = compare(a, b, 0.1);
  ASSERT_EQ(d.size(), 3u);
  EXPECT_EQ(d[0].channel, "R");
  EXPECT_EQ(d[0].distances.maximum, 0.0);
  EXPECT_EQ(d[1].channel, "G");
  EXPECT_EQ(d[1].distances.maximum, 0.5);
  EXPECT_EQ(d[1].distances.share, 0.5);
  EXPECT_EQ(d[2].channel, "B");
  EXPECT_EQ(d[2].distances.maximum, 0.0);
}

TEST(Compare, EqualNonFiniteValuesHaveDistanceZero) {
  const std::vector<float> odd = {kNan, kInfinity, -kInfinity, -0.0f};
  const ChannelDifference d = compareOne(odd, {kNan, kInfinity, -kInfinity, 0.0f}, 0.0);
  EXPECT_EQ(d.rmse, 0.0);
  EXPECT_EQ(d.relativeMse, 0.0);
  EXPECT_EQ(d.distances.maximum, 0.0);
  EXPECT_EQ(d.distances.percentile999, 0.0);
  EXPECT_EQ(d.distances.share, 0.0);
}

TEST(Compare, DifferentNonFiniteValuesHaveDistanceInfinity) {
  const std::vector<std::vector<float>> pairs = {
      {kNan, 1},        {1, kNan}, {kInfinity, 1}, {1, -kInfinity}, {kInfinity, -kInfinity},
      {kNan, kInfinity}};
  for (const std::vector<float>& pair : pairs) {
    for (const double tolerance : {0.0, kEndless}) {
      const ChannelDifference d = compareOne({pair[0], 5}, {pair[1], 5}, tolerance);
      EXPECT_EQ(d.rmse, kEndless) << pair[0] << " " << pair[1];
      EXPECT_EQ(d.relativeMse, kEndless);
      EXPECT_EQ(d.distances.maximum, kEndless);
      EXPECT_EQ(d.distances.share, 0.5);
    }
  }
}

TEST(Compare, RefusesPicturesThatDoNotMatch) {
  const Image a = rgbImage(4, 2);
  expectError(ExitCode::Usage, "4 x 2 and 2 x 4", [&] { compare(a, rgbImage(2, 4), 0.0); });
  Image b = a;
  b.channels[0] = "X";
  expectError(ExitCode::Usage, "B G R and B G X", [&] { compare(a, b, 0.0); });
  b = a;
  b.pixels.pop_back();
  expectError(ExitCode::Usage, "second picture", [&] { compare(a, b, 0.0); });
  expectError(ExitCode::Usage, "first picture",
              [&] { compare(rgbImage(0, 0), rgbImage(0, 0), 0.0); });
  expectError(ExitCode::Usage, "-1", [&] { compare(a, a, -1.0); });
  expectError(ExitCode::Usage, "nan",
              [&] { compare(a, a, std::numeric_limits<double>::quiet_NaN()); });
}

TEST(CompareReport, IsAnAlignedTable) {
  const std::string table =
      describe({{"R", 2.5, 0.25, {.percentile999 = 3, .maximum = 4, .share = 0.125}},
                {"N.X", 0, 0, {.percentile999 = kEndless}}},
               1e-3);
  EXPECT_EQ(table,
            "channel  RMSE  relative MSE  maximum  99.9th percentile  beyond 0.001\n"
            "R         2.5          0.25        4                  3        12.5 %\n"
            "N.X         0             0        0                inf           0 %\n");
}

TEST(CompareReport, WidensForLongNamesAndNumbers) {
  const std::string table =
      describe({{"diffuse.albedo.R", 1.23456789e-10, 0, {.share = 1e-7}}}, 0.0);
  EXPECT_EQ(table,
            "channel                RMSE  relative MSE  maximum  99.9th percentile  beyond 0\n"
            "diffuse.albedo.R  1.235e-10             0        0                  0   1e-05 %\n");
}

}  // namespace
}  // namespace laver::test
