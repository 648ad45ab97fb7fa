#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace laver::chart {

/// Places in the chart, both axes the better the smaller.
struct Place {
  double x, y;
};

/// Those that none other beats or equals on both axes, by growing x. Of equal ones the first. What
/// is not finite is passed over.
std::vector<std::size_t> paretoFront(std::span<const Place> places);

/// The slope of log y over log x by least squares, of places with both above 0; NaN of fewer than
/// two different x.
double logSlope(std::span<const Place> places);

/// A logarithmic axis.
struct LogAxis {
  double low = 1, high = 10;
  /// Where `value` lies, 0 to 1 on the axis.
  double at(double value) const;
  /// Powers of ten, on a short axis 1, 2 and 5 of each, on a shorter one more.
  std::vector<double> ticks() const;
};

/// An axis around values above 0, with some room; others are passed over.
LogAxis axisAround(std::span<const double> values);

}  // namespace laver::chart
