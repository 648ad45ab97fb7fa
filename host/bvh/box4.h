#pragma once
#include <bit>
#include <cstdint>
#include <limits>

namespace laver {

// Vectors of four floats, which gcc and clang support on every processor. Boxes use three lanes;
// the fourth holds arbitrary values.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 splat(float x) { return Float4{x, x, x, x}; }

/// A box in two registers; empty if lo > hi. Uninitialised by default.
struct Box4 {
  Float4 lo, hi;

  void grow(Float4 p) {
    lo = min(lo, p);
    hi = max(hi, p);
  }
  void grow(const Box4& b) {
    lo = min(lo, b.lo);
    hi = max(hi, b.hi);
  }
  /// Half the surface area; 0 for an empty box.
  float halfArea() const {
    const Float4 d = max(hi - lo, Float4{});
    const Float4 p = d * __builtin_shufflevector(d, d, 1, 2, 0, 3);
    return p[0] + p[1] + p[2];
  }
};

/// An empty box, for growing.
inline constexpr Box4 kEmptyBox{Float4{} + std::numeric_limits<float>::max(),
                                Float4{} + std::numeric_limits<float>::lowest()};

inline Box4 join(Box4 a, const Box4& b) {
  a.grow(b);
  return a;
}

/// Half the surface areas of three boxes.
inline Float4 halfAreas(const Box4& a, const Box4& b, const Box4& c) {
  const Float4 da = a.hi - a.lo, db = b.hi - b.lo, dc = c.hi - c.lo;
  const Float4 xy = __builtin_shufflevector(da, db, 0, 4, 1, 5);
  const Float4 zw = __builtin_shufflevector(da, db, 2, 6, 3, 7);
  const Float4 x = max(__builtin_shufflevector(xy, dc, 0, 1, 4, 7), Float4{});
  const Float4 y = max(__builtin_shufflevector(xy, dc, 2, 3, 5, 7), Float4{});
  const Float4 z = max(__builtin_shufflevector(zw, dc, 0, 1, 6, 7), Float4{});
  return x * y + y * z + z * x;
}

}  // namespace laver
