#include "bvh/split.h"

#include <algorithm>

namespace laver {

ItemBounds boundsOf(const BuildItem* items, std::uint32_t count) {
  ItemBounds bounds;
  for (std::uint32_t i = 0; i < count; ++i) bounds.grow(items[i].box);
  return bounds;
}

Binning::Binning(const Box4& centroids, std::uint32_t count)
    : lo_(centroids.lo),
      bins_(count >= 256  ? 32
            : count >= 24 ? 16
                          : 8) {
  const Float4 extent = centroids.hi - centroids.lo;
  // Slightly below the number of bins, so that the last centroid falls into the last bin.
  scale_ = extent > 1e-30F ? splat(static_cast<float>(bins_) * 0.99999F) / extent : Float4{};
}

Bins::Bins(unsigned bins) : bins_(bins) {
  for (unsigned i = 0; i < bins; ++i) {
    box_[i].fill(kEmptyBox);
    count_[i] = Int4{};
  }
}

void Bins::add(const Binning& binning, const BuildItem* items, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const Box4& box = items[i].box;
    const Int4 bin = binning.bin(box);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto b = static_cast<std::size_t>(bin[axis]);
      box_[b][axis].grow(box);
      ++reinterpret_cast<std::int32_t*>(&count_[b])[axis];
    }
  }
}

void Bins::add(const Bins& other) {
  for (unsigned i = 0; i < bins_; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) box_[i][axis].grow(other.box_[i][axis]);
    count_[i] += other.count_[i];
  }
}

Split Bins::cheapest(const Binning& binning) const {
  // One axis per lane. On an axis that can be split, the first and the last bin have items.
  std::array<Float4, Binning::kMaxBins> right;
  std::array<Box4, 3> box = box_[bins_ - 1];
  Int4 count = count_[bins_ - 1];
  for (unsigned i = bins_ - 1;; --i) {
    right[i] = halfAreas(box[0], box[1], box[2]) * __builtin_convertvector(count, Float4);
    if (i == 1) break;
    for (std::size_t axis = 0; axis < 3; ++axis) box[axis].grow(box_[i - 1][axis]);
    count += count_[i - 1];
  }
  Float4 minCost = splat(std::numeric_limits<float>::infinity());
  Int4 bin{}, leftCount{};
  box.fill(kEmptyBox);
  count = Int4{};
  for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(bins_); ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (std::size_t axis = 0; axis < 3; ++axis) box[axis].grow(box_[at][axis]);
    count += count_[at];
    const Float4 cost =
        halfAreas(box[0], box[1], box[2]) * __builtin_convertvector(count, Float4) + right[at + 1];
    const Int4 better = cost < minCost;
    bin = better ? Int4{i, i, i, i} : bin;
    leftCount = better ? count : leftCount;
    minCost = min(cost, minCost);
  }
  Split best;
  float bestCost = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (binning.splits(axis) && minCost[axis] < bestCost) {
      bestCost = minCost[axis];
      best = {axis, static_cast<unsigned>(bin[axis]), static_cast<std::uint32_t>(leftCount[axis])};
    }
  return best;
}

std::uint32_t Bins::upTo(const Split& split) const {
  std::int32_t count = 0;
  for (unsigned i = 0; i <= split.bin; ++i) count += count_[i][split.axis];
  return static_cast<std::uint32_t>(count);
}

}  // namespace laver
