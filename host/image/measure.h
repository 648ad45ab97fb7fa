#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/compare.h"

namespace laver {

/// What may differ between a picture and its reference.
struct Bound {
  std::string metric = "max";      ///< one of metricNames()
  double tolerance = 0.0;          ///< of the metric, in each channel; FLIP's mean
  std::optional<double> maxShare;  ///< bounds the share of pixels beyond the tolerance instead
};

/// Names of metrics. FLIP measures all channels together, the others each channel.
std::vector<std::string> metricNames();

/// How a picture differs from its reference.
struct Measured {
  std::vector<ChannelDifference> channels;
  std::optional<Distribution> flip;  ///< for the metrics flip and ldrflip
  std::vector<double> pixels;  ///< FLIP of each pixel, or the largest distance of its channels
};

/// Throws Error(Usage) as compare() and hdrFlip() do.
Measured measure(const Image& a, const Image& reference, const Bound& bound);

/// The number that is bounded, of the worst channel: the metric, or the share of pixels. Infinite
/// for NaN.
double figureOf(const Measured& measured, const Bound& bound);

/// The largest figure that is within the bound.
inline double limitOf(const Bound& bound) { return bound.maxShare.value_or(bound.tolerance); }

}  // namespace laver
