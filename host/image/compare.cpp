#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/numeric.h"
#include "image/difference.h"

namespace laver {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double relativeSquare(double difference, double reference) {
  if (difference == 0.0 || difference == kInfinity) return difference;
  return difference * difference / (reference * reference + 1e-2);
}

}  // namespace

std::vector<ChannelDifference> compare(const Image& a, const Image& b, double tolerance) {
  if (!(tolerance >= 0.0))
    throw Error(ExitCode::Usage, fmt::format("the tolerance {} is not 0 or more", tolerance));
  requireAlike(a, b);
  const std::vector<std::size_t> channels = matchingChannels(a, b);
  const std::size_t stride = a.channels.size();
  const std::size_t count = a.pixels.size() / stride;
  const auto n = static_cast<double>(count);
  std::vector<double> differences(count);
  std::vector<ChannelDifference> result;
  for (std::size_t channel = 0; channel < stride; ++channel) {
    ChannelDifference sum;
    sum.channel = a.channels[channel];
    for (std::size_t p = 0; p < count; ++p) {
      const auto reference = static_cast<double>(b.pixels[p * stride + channels[channel]]);
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
    sum.percentile999 = percentile(differences, 0.999);
    result.push_back(sum);
  }
  return result;
}

}  // namespace laver
