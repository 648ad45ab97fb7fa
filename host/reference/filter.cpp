#include "reference/filter.h"

#include <algorithm>
#include <cmath>

namespace laver::reference {

namespace {

// Gaussian of standard deviation s, lowered to reach 0 at the radius.
template <typename T>
T gaussian(T x, T radius, T stddev) {
  const T alpha = T(-1) / (T(2) * stddev * stddev);
  return std::max(T(0), std::exp(alpha * x * x) - std::exp(alpha * radius * radius));
}

// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics", 1988, equation 8, with
// its support of 2 stretched over the radius.
template <typename T>
T mitchell(T distance, T radius, T B, T C) {
  const T x = std::abs(T(2) * distance / radius);
  if (x < T(1)) {
    return ((T(12) - T(9) * B - T(6) * C) * x * x * x + (T(-18) + T(12) * B + T(6) * C) * x * x +
            (T(6) - T(2) * B)) /
           T(6);
  }
  if (x < T(2)) {
    return ((-B - T(6) * C) * x * x * x + (T(6) * B + T(30) * C) * x * x +
            (T(-12) * B - T(48) * C) * x + (T(8) * B + T(24) * C)) /
           T(6);
  }
  return T(0);
}

template <typename T>
T evaluate(const Filter& filter, T x) {
  const T radius = static_cast<T>(filter.radius);
  if (filter.row == &filters::gaussian) return gaussian(x, radius, static_cast<T>(filter.stddev));
  if (filter.row == &filters::mitchell)
    return mitchell(x, radius, static_cast<T>(filter.B), static_cast<T>(filter.C));
  if (filter.row == &filters::tent) return std::max(T(0), T(1) - std::abs(x) / radius);
  return T(1);
}

}  // namespace

FilterWeights::FilterWeights(const Filter& filter, bool noriCompat)
    : filter_(filter), noriCompat_(noriCompat) {
  const auto radius = static_cast<float>(filter.radius);
  for (int i = 0; i < resolution; ++i) {
    table_[static_cast<std::size_t>(i)] =
        evaluate(filter, radius * static_cast<float>(i) / static_cast<float>(resolution));
  }
}

double FilterWeights::operator()(double distance) const {
  distance = std::abs(distance);
  if (!(distance <= filter_.radius)) return 0.0;
  if (!noriCompat_) return evaluate(filter_, distance);
  const float factor = static_cast<float>(resolution) / static_cast<float>(filter_.radius);
  const auto entry = static_cast<int>(static_cast<float>(distance) * factor);
  return static_cast<double>(table_[static_cast<std::size_t>(std::min(entry, resolution))]);
}

int FilterWeights::reach() const { return static_cast<int>(std::floor(filter_.radius + 0.5)); }

}  // namespace laver::reference
