#include "image/srgb.h"

#include <cmath>

namespace laver {

std::uint8_t srgb8(float linear) {
  if (!(linear > 0.0f)) return 0;  // NaN too
  if (linear >= 1.0f) return 255;
  const auto x = static_cast<double>(linear);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * y));
}

}  // namespace laver
