#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"

namespace laver {

/// Numbers of all pixels. A percentile is the smallest number that so many do not exceed.
struct Distribution {
  double mean = 0;
  double median = 0, percentile95 = 0, percentile99 = 0, percentile999 = 0, maximum = 0;
  double share = 0;  ///< of pixels whose number exceeds the tolerance
};

/// A number of a distribution that is named on the command line.
struct Statistic {
  std::string_view name;
  double Distribution::*value;
};
inline constexpr Statistic kStatistics[] = {
    {"max", &Distribution::maximum},      {"mean", &Distribution::mean},
    {"p50", &Distribution::median},       {"p95", &Distribution::percentile95},
    {"p99", &Distribution::percentile99}, {"p999", &Distribution::percentile999}};

Distribution distributionOf(std::vector<double> numbers, double tolerance);

/// The difference between two images in one channel, over all pixels.
struct ChannelDifference {
  std::string channel;
  double rmse = 0;         ///< root of the mean squared difference
  double relativeMse = 0;  ///< mean of (a - b)^2 / (b^2 + 1e-2), b the reference
  Distribution distances;  ///< of |a - b|
};

/// Compares a with the reference b, channel by channel, by distance(). Throws Error(Usage) if sizes
/// or channel names differ.
std::vector<ChannelDifference> compare(const Image& a, const Image& b, double tolerance);

/// An aligned table: a line of headings, then one line per channel, each ended by a newline.
/// `tolerance` is that of compare(); the share of pixels beyond it is printed in percent.
std::string describe(const std::vector<ChannelDifference>& differences, double tolerance);

/// a - b|. If one is not finite: 0 if both are equal infinities or both NaN, else infinity.
double distance(double a, double b);

/// a - b with a's channels; 0 where distance() is 0. Throws as compare().
Image difference(const Image& a, const Image& b);

/// The largest distance over the channels, per pixel. Throws as compare().
std::vector<double> largestDistances(const Image& a, const Image& b);

}  // namespace laver
