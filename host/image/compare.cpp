#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"

namespace laver {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double relativeSquare(double difference, double reference) {
  if (difference == 0.0 || difference == kInfinity) return difference;
  return difference * difference / (reference * reference + 1e-2);
}

/// The smallest of the values that all but 1 / `rest` of them do not exceed (nearest rank).
/// Reorders them.
double percentile(std::vector<double>& values, std::size_t rest) {
  const std::size_t rank = values.size() - values.size() / rest;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Throws Error(Usage) unless both are pictures of one size with the same channels in any order.
void requireAlike(const Image& a, const Image& b) {
  const auto refuse = [](const std::string& reason) { throw Error(ExitCode::Usage, reason); };
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

/// For each channel of a, its index among b's channels.
std::vector<std::size_t> matchingChannels(const Image& a, const Image& b) {
  std::vector<std::size_t> indices;
  for (const std::string& name : a.channels)
    indices.push_back(static_cast<std::size_t>(
        std::find(b.channels.begin(), b.channels.end(), name) - b.channels.begin()));
  return indices;
}

/// Calls use(i, value of a, value of b) for every number i of a.
template <class Use>
void forPairs(const Image& a, const Image& b, Use use) {
  requireAlike(a, b);
  const std::vector<std::size_t> channels = matchingChannels(a, b);
  const std::size_t stride = channels.size();
  for (std::size_t p = 0; p < a.pixels.size(); p += stride)
    for (std::size_t c = 0; c < stride; ++c)
      use(p + c, static_cast<double>(a.pixels[p + c]),
          static_cast<double>(b.pixels[p + channels[c]]));
}

}  // namespace

Distribution distributionOf(std::vector<double> numbers, double tolerance) {
  Distribution result;
  const auto count = static_cast<double>(numbers.size());
  for (const double x : numbers) {
    result.mean += x / count;
    result.maximum = std::max(result.maximum, x);
    if (x > tolerance || x == kInfinity) result.share += 1.0;
  }
  result.share /= count;
  result.median = percentile(numbers, 2);
  result.percentile95 = percentile(numbers, 20);
  result.percentile99 = percentile(numbers, 100);
  result.percentile999 = percentile(numbers, 1000);
  return result;
}

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
    }
    sum.rmse = std::sqrt(sum.rmse / n);
    sum.relativeMse /= n;
    sum.distances = distributionOf(differences, tolerance);
    result.push_back(sum);
  }
  return result;
}

std::string describe(const std::vector<ChannelDifference>& differences, double tolerance) {
  using Row = std::array<std::string, 6>;
  std::vector<Row> rows = {{"channel", "RMSE", "relative MSE", "maximum", "99.9th percentile",
                            fmt::format("beyond {:g}", tolerance)}};
  for (const ChannelDifference& d : differences) {
    rows.push_back({d.channel, fmt::format("{:.4g}", d.rmse), fmt::format("{:.4g}", d.relativeMse),
                    fmt::format("{:.4g}", d.distances.maximum),
                    fmt::format("{:.4g}", d.distances.percentile999),
                    fmt::format("{:.4g} %", 100.0 * d.distances.share)});
  }
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string table;
  for (const Row& row : rows) {
    table += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) {
      table += fmt::format("  {:>{}}", row[i], widths[i]);
    }
    table += '\n';
  }
  return table;
}

double distance(double a, double b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::abs(a - b);
  const bool alike = a == b || (std::isnan(a) && std::isnan(b));
  return alike ? 0.0 : std::numeric_limits<double>::infinity();
}

Image difference(const Image& a, const Image& b) {
  Image result = a;
  forPairs(a, b, [&](std::size_t i, double x, double y) {
    result.pixels[i] = distance(x, y) == 0.0 ? 0.0F : static_cast<float>(x - y);
  });
  return result;
}

std::vector<double> largestDistances(const Image& a, const Image& b) {
  std::vector<double> largest(a.pixels.size() / std::max<std::size_t>(a.channels.size(), 1));
  forPairs(a, b, [&](std::size_t i, double x, double y) {
    double& value = largest[i / a.channels.size()];
    value = std::max(value, distance(x, y));
  });
  return largest;
}

}  // namespace laver
