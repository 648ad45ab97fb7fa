#include <algorithm>
#include <cmath>

#include "reference/filter.h"

namespace laver::reference {

namespace {

template <typename T>
T at(const Filter& filter, T x) {
  return std::max(T(0), T(1) - std::abs(x) / static_cast<T>(filter.radius));
}

}  // namespace

extern const FilterTwin tent;
const FilterTwin tent{at<double>, at<float>};

}  // namespace laver::reference
