#include "image/noise_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdlib>

#include "core/error.h"
#include "image/io.h"

namespace laver {
namespace {

constexpr std::array kColours = {"R", "G", "B"};

/// Values of float renders are off by rounding, too: by up to 5e-5 of their size where textures and
/// shadows are exact (the pictures of device and reference), which counts as two standard errors.
constexpr double kRounding = 2.5e-5;

std::size_t channelOf(const Image& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  if (found == image.channels.end())
    throw Error(ExitCode::Usage,
                fmt::format("--noise needs the channels R, G, B and variance.R, variance.G, "
                            "variance.B in both pictures, {} is missing: render with --layers "
                            "variance",
                            name));
  return static_cast<std::size_t>(found - image.channels.begin());
}

/// A colour and its variance.
struct Channels {
  std::array<std::size_t, 3> value, variance;
  explicit Channels(const Image& image) {
    for (std::size_t c = 0; c < 3; ++c) {
      value[c] = channelOf(image, kColours[c]);
      variance[c] = channelOf(image, std::string("variance.") + kColours[c]);
    }
  }
};

/// Probability that |z| is at least as large. Of differences that are not finite, 0.
double twoSided(double z) {
  if (!std::isfinite(z)) return 0.0;
  return 2.0 * cdf(complement(boost::math::normal(), std::abs(z)));
}

/// Probability that the smallest of n independent p is at most p.
double ofMany(double p, double n) { return -std::expm1(n * std::log1p(-std::min(p, 1.0))); }

class Test {
 public:
  Test(const Image& a, const Image& b) : a_(a), b_(b), inA_(a), inB_(b) {
    if (a.width != b.width || a.height != b.height)
      throw Error(ExitCode::Usage, fmt::format("pictures of {}x{} and {}x{} pixels", a.width,
                                               a.height, b.width, b.height));
  }

  /// a - b, and its variance.
  struct Gap {
    double difference, variance;
  };
  Gap gap(int x, int y, std::size_t c) const {
    const double a{a_.at(x, y, inA_.value[c])}, b{b_.at(x, y, inB_.value[c])};
    const double rounding = kRounding * std::max(std::abs(a), std::abs(b));
    return {a - b, double{a_.at(x, y, inA_.variance[c])} + double{b_.at(x, y, inB_.variance[c])} +
                       rounding * rounding};
  }
  double value(int x, int y, std::size_t c) const { return double{b_.at(x, y, inB_.value[c])}; }

 private:
  const Image& a_;
  const Image& b_;
  Channels inA_, inB_;
};

double zOf(const Test::Gap& gap) {
  return gap.difference == 0.0 ? 0.0 : gap.difference / std::sqrt(gap.variance);
}

}  // namespace

NoiseTest testNoise(const Image& a, const Image& b, const NoiseLimits& limits, int reach) {
  const Test test(a, b);
  NoiseTest result;
  result.pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
  const double each = 0.5 * limits.significance, many = 3.0 * static_cast<double>(result.pixels);
  const int stride = 2 * reach + 1;
  std::array<Test::Gap, 3> sums{};
  std::array<double, 3> values{};
  std::size_t agree = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      double least = 1.0;
      for (std::size_t c = 0; c < 3; ++c) {
        const Test::Gap gap = test.gap(x, y, c);
        least = std::min(least, twoSided(zOf(gap)));
        if (x % stride != 0 || y % stride != 0) continue;
        sums[c].difference += gap.difference;
        sums[c].variance += gap.variance;
        values[c] += test.value(x, y, c);
      }
      result.p.push_back(ofMany(least, many));
      agree += result.p.back() >= each ? 1 : 0;
    }
  }
  result.smallest = *std::min_element(result.p.begin(), result.p.end());
  result.agree = static_cast<double>(agree) / static_cast<double>(result.pixels);
  for (std::size_t c = 0; c < 3; ++c) {
    const double p = ofMany(twoSided(zOf(sums[c])), 3.0);
    if (c != 0 && p >= result.meanP) continue;
    result.meanP = p;
    result.meanDifference = values[c] == 0.0 ? 0.0 : sums[c].difference / values[c];
  }
  result.passed = result.agree >= limits.pass && result.meanP >= each;
  return result;
}

int filterReachOf(std::span<const std::string> files) {
  int reach = 0;
  for (const std::string& file : files) {
    const auto attributes = readExrTexts(file);
    const auto found = attributes.find("filterReach");
    reach = std::max(reach, found == attributes.end() ? 2 : std::atoi(found->second.c_str()));
  }
  return reach;
}

}  // namespace laver
