#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"
#include "image/image_defect.h"

namespace laver {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// |a - b|; 0 for alike that are not finite, infinite for unlike.
double distance(double a, double b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::abs(a - b);
  const bool alike = a == b || (std::isnan(a) && std::isnan(b));
  return alike ? 0.0 : kInfinity;
}

double relativeSquare(double difference, double reference) {
  if (difference == 0.0 || difference == kInfinity) return difference;
  return difference * difference / (reference * reference + 1e-2);
}

/// The smallest of the values that 99.9 % of them do not exceed (nearest rank). Reorders them.
double percentile999(std::vector<double>& values) {
  const std::size_t rank = values.size() - values.size() / 1000;  // ceil(0.999 size)
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

std::size_t matchingChannel(const Image& b, const std::string& name) {
  return static_cast<std::size_t>(std::find(b.channels.begin(), b.channels.end(), name) -
                                  b.channels.begin());
}

void requireComparable(const Image& a, const Image& b, double tolerance) {
  const auto refuse = [](const std::string& reason) { throw Error(ExitCode::Usage, reason); };
  if (!(tolerance >= 0.0)) refuse(fmt::format("the tolerance {} is not 0 or more", tolerance));
  for (const Image* image : {&a, &b}) {
    if (const std::string defect = imageDefect(*image); !defect.empty()) {
      refuse(fmt::format("the {} picture is broken: {}", image == &a ? "first" : "second", defect));
    }
  }
  if (a.width != b.width || a.height != b.height) {
    refuse(fmt::format("the pictures differ in size: {} x {} and {} x {} pixels", a.width, a.height,
                       b.width, b.height));
  }
  const std::set<std::string> first(a.channels.begin(), a.channels.end());
  const std::set<std::string> second(b.channels.begin(), b.channels.end());
  if (first != second) {
    refuse(fmt::format("the pictures differ in channels: {} and {}", fmt::join(first, " "),
                       fmt::join(second, " ")));
  }
}

}  // namespace

std::vector<ChannelDifference> compare(const Image& a, const Image& b, double tolerance) {
  requireComparable(a, b, tolerance);
  const std::size_t stride = a.channels.size();
  const std::size_t count = a.pixels.size() / stride;
  const auto n = static_cast<double>(count);
  std::vector<double> differences(count);
  std::vector<ChannelDifference> result;
  for (std::size_t channel = 0; channel < stride; ++channel) {
    const std::size_t other = matchingChannel(b, a.channels[channel]);
    ChannelDifference sum;
    sum.channel = a.channels[channel];
    for (std::size_t p = 0; p < count; ++p) {
      const auto reference = static_cast<double>(b.pixels[p * stride + other]);
      const double d = distance(static_cast<double>(a.pixels[p * stride + channel]), reference);
      differences[p] = d;
      sum.rmse += d * d;
      sum.relativeMse += relativeSquare(d, reference);
      sum.maximum = std::max(sum.maximum, d);
      if (d > tolerance || d == kInfinity) sum.share += 1.0;
    }
    sum.rmse = std::sqrt(sum.rmse / n);
    sum.relativeMse /= n;
    sum.share /= n;
    sum.percentile999 = percentile999(differences);
    result.push_back(sum);
  }
  return result;
}

}  // namespace laver
