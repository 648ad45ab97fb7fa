#include <cmath>

#include "reference/filter.h"

namespace laver::reference {

namespace {

// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics", 1988, equation 8, with
// its support of 2 scaled to the radius.
template <typename T>
T at(const Filter& filter, T distance) {
  const T radius = static_cast<T>(filter.radius);
  const T B = static_cast<T>(filter.B), C = static_cast<T>(filter.C);
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

}  // namespace

extern const FilterTwin mitchell;
const FilterTwin mitchell{at<double>, at<float>};

}  // namespace laver::reference
