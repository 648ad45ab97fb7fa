#include "lab/chart/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laver::chart {

double LogAxis::at(double value) const { return std::log(value / low) / std::log(high / low); }

std::vector<double> LogAxis::ticks() const {
  const std::vector<double> mantissas[] = {
      {1},
      {1, 2, 5},
      {1, 2, 3, 4, 5, 6, 7, 8, 9},
      {1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 4.5, 5, 6, 7, 8, 9}};
  std::vector<double> all;
  for (const std::vector<double>& each : mantissas) {
    all.clear();
    for (int e = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, e) <= high; ++e)
      for (const double mantissa : each) {
        const double value = mantissa * std::pow(10.0, e);
        if (value >= low && value <= high) all.push_back(value);
      }
    if (all.size() >= 3 && (each.size() > 1 || high / low >= 200.0)) break;
  }
  return all;
}

LogAxis axisAround(std::span<const double> values) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const double v : values) {
    if (!(v > 0.0) || !std::isfinite(v)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (high == 0.0) return {};
  const double room = std::max(1.25, std::pow(high / low, 0.06));
  return {low / room, high * room};
}

}  // namespace laver::chart
