#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

/// The difference between two images in one channel, over all pixels.
struct ChannelDifference {
  std::string channel;
  double rmse = 0;           ///< root of the mean squared difference
  double relativeMse = 0;    ///< mean of (a - b)^2 / (b^2 + 1e-2), b the reference
  double maximum = 0;        ///< largest |a - b|
  double percentile999 = 0;  ///< 99.9th percentile of |a - b|
  double share = 0;          ///< share of pixels with distance(a, b) > tolerance
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
