#pragma once
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

/// How one channel of two pictures differs. Differences are a - b over all pixels.
struct ChannelDifference {
  std::string channel;
  double rmse = 0;           ///< root of the mean squared difference
  double relativeMse = 0;    ///< mean of (a - b)^2 / (b^2 + 1e-2), b the reference
  double maximum = 0;        ///< largest |a - b|
  double percentile999 = 0;  ///< smallest |a - b| that 99.9 % of the pixels do not exceed
  double share = 0;          ///< share of pixels with |a - b| > tolerance or not finite in one only
};

/// Compares a with the reference b, channel by channel. Throws Error(Usage) if sizes or channel
/// names differ. NaN equals NaN and an infinity its like; otherwise they differ infinitely.
std::vector<ChannelDifference> compare(const Image& a, const Image& b, double tolerance);

}  // namespace laver
