#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/numeric.h"

namespace laver::test {

inline double maximum(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// "p99 / max".
inline std::string bounds(const std::vector<double>& values) {
  return fmt::format("{:.3g} / {:.3g}", percentile(values, 0.99), maximum(values));
}

}  // namespace laver::test
