#pragma once
#include <array>

#include "scene/filters.h"

namespace laver::reference {

/// The weight of a filter at a distance of at most its radius, in two precisions.
struct FilterTwin {
  double (*exact)(const Filter& filter, double distance);
  float (*single)(const Filter& filter, float distance);
};

/// One axis of a separable reconstruction filter.
class FilterWeights {
 public:
  /// Exact weights or, with `noriCompat`, Nori's table of 32 float entries over the radius.
  FilterWeights(const Filter& filter, bool noriCompat);

  /// The weight at `distance` pixels from the pixel's centre; 0 if |distance| > radius.
  double operator()(double distance) const;

  /// A sample of pixel x may affect the pixels x - reach() to x + reach(). It lies in [x, x + 1],
  /// both ends included, since the float sum pixel + number may round up.
  int reach() const;

 private:
  static constexpr int resolution = 32;
  Filter filter_;
  bool noriCompat_;
  std::array<float, resolution + 1> table_{};
};

}  // namespace laver::reference
