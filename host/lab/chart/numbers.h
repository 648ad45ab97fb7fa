#pragma once
#include <span>
#include <vector>

namespace laver::chart {

/// A logarithmic axis.
struct LogAxis {
  double low = 1, high = 10;
  /// The position of `value` on the axis, 0 to 1.
  double at(double value) const;
  /// Powers of ten; on a short axis 1, 2 and 5 times these, on a shorter one more.
  std::vector<double> ticks() const;
};

/// An axis around the positive values, with a margin; other values are ignored.
LogAxis axisAround(std::span<const double> values);

}  // namespace laver::chart
