#include "core/numeric.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laver {

double maxNorm(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double ulpOf(double x) {
  const float rounded = std::abs(static_cast<float>(x));
  return static_cast<double>(std::nextafter(rounded, std::numeric_limits<float>::infinity()) -
                             rounded);
}

double ulps(float value, double truth) {
  return std::abs(static_cast<double>(value) - truth) / ulpOf(truth);
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto nth = values.begin() + std::max(rank, std::ptrdiff_t{1}) - 1;
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double rank = q * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(rank);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return std::lerp(values[low], values[high], rank - static_cast<double>(low));
}

}  // namespace laver
