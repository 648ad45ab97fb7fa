#include "bvh/slots.h"

#include <algorithm>
#include <limits>

namespace laver {

using shared::NODE_WIDTH;

std::array<unsigned, NODE_WIDTH> assignSlots(const Box4& box, std::span<const Box4> children) {
  static_assert(NODE_WIDTH == 8);
  constexpr float kTaken = -std::numeric_limits<float>::infinity();
  // The low bits of a score hold the pair's number, 8 child + slot, so that the maximum identifies
  // the best pair.
  constexpr std::int32_t kNumber = 63;
  const Float4 centre = box.lo + box.hi;
  std::array<Float4, NODE_WIDTH> low, high;  // scores of slots 0 to 3 and 4 to 7
  for (std::size_t c = 0; c < children.size(); ++c) {
    // Clamped to finite values, so that each child gets a slot even if sums overflow.
    const Float4 o =
        max(min((children[c].lo + children[c].hi) - centre, splat(1e30F)), splat(-1e30F));
    const Float4 xy = Float4{-o[0], o[0], -o[0], o[0]} + Float4{-o[1], -o[1], o[1], o[1]};
    const Int4 number = Int4{0, 1, 2, 3} + static_cast<std::int32_t>(8 * c);
    const auto numbered = [number](Float4 score, std::int32_t first) {
      return std::bit_cast<Float4>((std::bit_cast<Int4>(score) & ~kNumber) | (number + first));
    };
    low[c] = numbered(xy - o[2], 0);
    high[c] = numbered(xy + o[2], 4);
  }
  std::array<unsigned, NODE_WIDTH> slotOf{};
  Int4 freeLow = {-1, -1, -1, -1}, freeHigh = freeLow;
  for (std::size_t round = 0; round < children.size(); ++round) {
    Float4 maxLow = splat(kTaken), maxHigh = maxLow;
    for (std::size_t c = 0; c < children.size(); ++c) {
      maxLow = max(low[c], maxLow);
      maxHigh = max(high[c], maxHigh);
    }
    const Float4 maxima = max(freeLow ? maxLow : kTaken, freeHigh ? maxHigh : kTaken);
    const float best = std::max(std::max(maxima[0], maxima[1]), std::max(maxima[2], maxima[3]));
    const auto number = static_cast<unsigned>(std::bit_cast<std::int32_t>(best) & kNumber);
    const unsigned child = number / 8, slot = number % 8;
    slotOf[child] = slot;
    low[child] = high[child] = splat(kTaken);
    const auto taken = static_cast<std::int32_t>(slot);
    freeLow &= Int4{0, 1, 2, 3} != taken;
    freeHigh &= Int4{4, 5, 6, 7} != taken;
  }
  return slotOf;
}

}  // namespace laver
