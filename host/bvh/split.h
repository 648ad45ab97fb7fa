#pragma once
#include <array>
#include <cstdint>

#include "bvh/box4.h"
#include "bvh/items.h"

namespace laver {

/// ItemBounds of items and of their centroids (times two, which saves a product).
struct ItemBounds {
  Box4 box = kEmptyBox, centroids = kEmptyBox;
  void grow(const Box4& item) {
    box.grow(item);
    centroids.grow(item.lo + item.hi);
  }
};
ItemBounds boundsOf(const BuildItem* items, std::uint32_t count);

/// Maps centroids to bins on all three axes; an axis without extent has scale 0.
class Binning {
 public:
  Binning(const Box4& centroids, std::uint32_t count);
  unsigned bins() const { return bins_; }
  bool splits(int axis) const { return scale_[axis] > 0.0F; }
  Int4 bin(const Box4& item) const {
    // Non-finite values convert to the lowest integer, and thus to bin 0.
    return __builtin_convertvector(((item.lo + item.hi) - lo_) * scale_, Int4) & (kMaxBins - 1);
  }
  /// Whether bin(item)[axis] > bin, exactly.
  bool beyond(const BuildItem& item, int axis, unsigned bin) const {
    return ((item.box.lo[axis] + item.box.hi[axis]) - lo_[axis]) * scale_[axis] >=
           static_cast<float>(bin + 1);
  }
  static constexpr int kMaxBins = 32;

 private:
  Float4 lo_;
  Float4 scale_{};
  unsigned bins_;
};

struct Split {
  int axis = -1;     ///< -1: no plane separates the items
  unsigned bin = 0;  ///< items of bins <= bin go left
  std::uint32_t leftCount = 0;
};

/// Counts and bounds of items in bins on three axes.
class Bins {
 public:
  explicit Bins(unsigned bins);
  void add(const Binning& binning, const BuildItem* items, std::uint32_t count);
  void add(const Bins& other);
  /// The plane of minimum SAH cost (Wald, "On fast Construction of SAH-based Bounding Volume
  /// Hierarchies", 2007).
  Split cheapest(const Binning& binning) const;
  std::uint32_t upTo(const Split& split) const;

 private:
  unsigned bins_;
  std::array<std::array<Box4, 3>, Binning::kMaxBins> box_;
  std::array<Int4, Binning::kMaxBins> count_;
};

}  // namespace laver
