#include <cmath>

#include "reference/texture.h"

namespace laver::reference {

namespace {

/// The value at a corner, by the generator pcg2d of Jarzynski and Olano, "Hash Functions for GPU
/// Rendering" (2020).
double cornerValue(std::int64_t column, std::int64_t row) {
  constexpr std::uint32_t kFactor = 1664525, kTerm = 1013904223;
  std::uint32_t x = static_cast<std::uint32_t>(column) * kFactor + kTerm;
  std::uint32_t y = static_cast<std::uint32_t>(row) * kFactor + kTerm;
  for (int round = 0; round < 2; ++round) {
    x += y * kFactor;
    y += x * kFactor;
    x ^= x >> 16;
    y ^= y >> 16;
  }
  return (x >> 8) / 16777216.0;
}

/// Corner values blended by 3 w^2 - 2 w^3 on each axis.
double blended(double s, double t) {
  const double left = std::floor(s), low = std::floor(t);
  const auto share = [](double w) { return w * w * (3.0 - 2.0 * w); };
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    const int right = i % 2, up = i / 2;
    const double across = share(s - left), along = share(t - low);
    sum +=
        (right == 1 ? across : 1.0 - across) * (up == 1 ? along : 1.0 - along) *
        cornerValue(static_cast<std::int64_t>(left) + right, static_cast<std::int64_t>(low) + up);
  }
  return sum;
}

}  // namespace

glm::dvec3 noise(const Texture&, glm::dvec2 st) {
  double sum = 0.0;
  for (int octave = 0; octave < 9; ++octave)
    sum += std::ldexp(blended(std::ldexp(st.x, -octave), std::ldexp(st.y, -octave)), octave);
  return glm::dvec3(sum / 511.0);
}

}  // namespace laver::reference
