#pragma once
#include <span>
#include <vector>

namespace laver::chart {

/// Linear interpolation between ranks; q = 0.5 is the median. 0 of no values.
double quantile(std::vector<double> values, double q);

/// A logarithmic axis.
struct LogAxis {
  double low = 1, high = 10;
  /// Where `value` lies, 0 to 1 on the axis.
  double at(double value) const;
  /// Powers of ten; on a short axis 1, 2 and 5 of each, on a shorter one more.
  std::vector<double> ticks() const;
};

/// An axis around values above 0, with some room; others are ignored.
LogAxis axisAround(std::span<const double> values);

}  // namespace laver::chart
