#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

struct NoiseLimits {
  double significance = 0.01;  ///< how often pictures with equal expectations fail
  double pass = 0.9975;        ///< share of the pixels that must agree
};

/// Whether two pictures have the same expectations.
struct NoiseTest {
  std::size_t pixels = 0;
  /// Of each pixel, corrected for their number: how likely is it that, with equal expectations,
  /// any of as many pixels is so far apart.
  std::vector<double> p;
  double smallest = 1.0;  ///< of these
  double agree = 1.0;     ///< share of the pixels whose p is at least half of the significance
  double meanDifference = 0.0, meanP = 1.0;  ///< of the channel whose means are least alike
  bool passed = true;
};

/// Compares pictures with the channels R, G, B and the variances of each in variance.R, .G, .B, by
/// two tests that share the significance. Both take sums of many samples as normally distributed.
///
/// Of each pixel: z = (a - b) / sqrt(var a + var b), p by Sidak's correction ("Rectangular
/// Confidence Regions for the Means of Multivariate Normal Distributions", 1967) for the number of
/// pixels and channels, as in Mitsuba's tests (Jakob and others).
///
/// Of the means: z of the sum over pixels so far apart that their filters, which reach `reach`
/// pixels, share no sample. It finds what is too small for single pixels.
///
/// Throws Error(Usage) if sizes differ or channels are missing.
NoiseTest testNoise(const Image& a, const Image& b, const NoiseLimits& limits, int reach);

/// The largest filter of EXR files that laver wrote, in pixels; of others, that of Nori's filter.
/// Throws Error(Usage) as readExr() does.
int filterReachOf(std::span<const std::string> files);

}  // namespace laver
