#pragma once
#include <bit>
#include <cstdint>

namespace laver::reference {

/// PCG32, "PCG-XSH-RR" with 64 bits of state (O'Neill, "PCG: A Family of Simple Fast
/// Space-Efficient Statistically Good Algorithms for Random Number Generation", 2014).
class Pcg32 {
 public:
  /// `initstate` selects the position in a stream, `initseq` the stream.
  Pcg32(std::uint64_t initstate, std::uint64_t initseq) : increment_((initseq << 1) | 1u) {
    next();
    state_ += initstate;
    next();
  }

  /// 32 uniform bits.
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * multiplier + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    return std::rotr(shifted, static_cast<int>(old >> 59));
  }

  /// Uniform in [0, 1): 23 bits become the mantissa of a float in [1, 2), less 1.
  float nextFloat() { return std::bit_cast<float>((next() >> 9) | 0x3f800000u) - 1.0f; }

  /// Skips `count` numbers by squaring the map x -> a x + c once per bit of `count` (Brown, "Random
  /// Number Generation with Arbitrary Strides", 1994).
  void advance(std::uint64_t count) {
    std::uint64_t a = multiplier, c = increment_;
    for (; count != 0; count >>= 1) {
      if (count & 1) state_ = state_ * a + c;
      c *= a + 1;
      a *= a;
    }
  }

 private:
  static constexpr std::uint64_t multiplier = 6364136223846793005u;
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace laver::reference
