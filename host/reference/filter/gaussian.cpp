#include <algorithm>
#include <cmath>

#include "reference/filter.h"

namespace laver::reference {

namespace {

// A Gaussian, lowered to reach 0 at the radius.
template <typename T>
T at(const Filter& filter, T x) {
  const T radius = static_cast<T>(filter.radius), stddev = static_cast<T>(filter.stddev);
  const T alpha = T(-1) / (T(2) * stddev * stddev);
  return std::max(T(0), std::exp(alpha * x * x) - std::exp(alpha * radius * radius));
}

}  // namespace

extern const FilterTwin gaussian;
const FilterTwin gaussian{at<double>, at<float>};

}  // namespace laver::reference
