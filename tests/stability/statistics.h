#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace laver::test {

/// The value that a share of the samples does not exceed; 0 of none.
inline double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = std::min(values.size() - 1,
                           static_cast<std::size_t>(share * static_cast<double>(values.size())));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

inline double maximum(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// "p99 / max".
inline std::string bounds(const std::vector<double>& values) {
  return fmt::format("{:.3g} / {:.3g}", percentile(values, 0.99), maximum(values));
}

}  // namespace laver::test
