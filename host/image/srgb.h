#pragma once
#include <array>
#include <bit>
#include <cstdint>

namespace laver {

/// 255 times the sRGB transfer curve of IEC 61966-2-1, clamped to [0, 1] and rounded to nearest.
/// NaN gives 0.
std::uint8_t srgb8(float linear);

/// srgb8() by table, bit for bit. Within a bucket of floats that agree in all but their lowest 16
/// bits, srgb8() varies by at most 1, since the curve rises by 255 / 2.4 / 128 < 1 over 1/128 of
/// its argument.
class SrgbTable {
 public:
  static const SrgbTable& shared();

  std::uint8_t operator()(float linear) const {
    if (!(linear >= kLow)) return 0;  // NaN too
    if (linear >= 1.0f) return 255;
    const Bucket& bucket = buckets_[(std::bit_cast<std::uint32_t>(linear) >> 16) - kFirst];
    return static_cast<std::uint8_t>(bucket.value + (linear >= bucket.next ? 1 : 0));
  }

 private:
  struct Bucket {
    float next;  ///< from here on `value` + 1; infinity if the bucket has one value
    std::uint8_t value;
  };
  static constexpr float kLow = 0x1p-13f;  ///< 255 * 12.92 * 2^-13 < 1/2
  static constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kLow) >> 16;
  static constexpr std::uint32_t kEnd = std::bit_cast<std::uint32_t>(1.0f) >> 16;

  SrgbTable();
  std::array<Bucket, kEnd - kFirst> buckets_;
};

}  // namespace laver
