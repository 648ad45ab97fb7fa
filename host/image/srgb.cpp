#include "image/srgb.h"

#include <cmath>
#include <limits>

namespace laver {

std::uint8_t srgb8(float linear) {
  if (!(linear > 0.0f)) return 0;  // NaN too
  if (linear >= 1.0f) return 255;
  const auto x = static_cast<double>(linear);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * y));
}

const SrgbTable& SrgbTable::shared() {
  static const SrgbTable table;
  return table;
}

SrgbTable::SrgbTable() {
  for (std::uint32_t i = 0; i < buckets_.size(); ++i) {
    std::uint32_t low = (kFirst + i) << 16, high = low | 0xffff;
    Bucket& bucket = buckets_[i];
    bucket = {std::numeric_limits<float>::infinity(), srgb8(std::bit_cast<float>(low))};
    if (srgb8(std::bit_cast<float>(high)) == bucket.value) continue;
    while (high - low > 1) {
      const std::uint32_t middle = (low + high) / 2;
      (srgb8(std::bit_cast<float>(middle)) == bucket.value ? low : high) = middle;
    }
    bucket.next = std::bit_cast<float>(high);
  }
}

}  // namespace laver
