#include "bvh/binary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "core/parallel.h"

namespace laver {
namespace {

constexpr unsigned kBins = 32;
/// Ranges above this many items are binned by several threads.
constexpr std::uint32_t kParallelBinning = 1U << 15;

/// Items [first, first + count) to be split below node `node`.
struct Range {
  std::uint32_t node, first, count;
  unsigned depth;
};

struct Bin {
  Box box;
  std::uint32_t count = 0;
};
using Bins = std::array<std::array<Bin, kBins>, 3>;

/// Twice the centroid, which keeps it exact enough and saves a product.
glm::vec3 centroid(const Box& box) { return box.lo + box.hi; }

/// Maps centroids to bins; an axis without extent has scale 0 and is not split.
struct Binning {
  glm::vec3 lo{0.0F}, scale{0.0F};

  explicit Binning(const Box& centroids) : lo(centroids.lo) {
    for (int a = 0; a < 3; ++a) {
      const float extent = centroids.hi[a] - centroids.lo[a];
      // Just below kBins, so that the last centroid falls into the last bin.
      if (extent > 1e-30F) scale[a] = static_cast<float>(kBins) * 0.99999F / extent;
    }
  }
  unsigned bin(glm::vec3 c, int axis) const {
    return std::min(static_cast<unsigned>((c[axis] - lo[axis]) * scale[axis]), kBins - 1);
  }
};

struct Split {
  int axis = -1;
  unsigned bin = 0;  ///< items of bins <= bin go left
};

class Builder {
 public:
  Builder(std::vector<BuildItem>& items, unsigned threads) : items_(items), threads_(threads) {
    nodes_.resize(2 * items.size() - 1);
  }

  std::vector<BinaryNode> build() {
    // Large ranges one after the other, each binned by all threads, then small ones side by side.
    const auto total = static_cast<std::uint32_t>(items_.size());
    const std::uint32_t small = std::max(total / (8 * threadCount(threads_)), 1024U);
    std::vector<Range> large{{0, 0, total, 0}}, rest;
    while (!large.empty()) {
      const Range range = large.back();
      large.pop_back();
      if (range.count <= small) {
        rest.push_back(range);
        continue;
      }
      const auto [left, right] = split(range, true);
      large.push_back(right);
      large.push_back(left);
    }
    parallelFor(rest.size(), 1, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) buildBelow(rest[i]);
    });
    return std::move(nodes_);
  }

 private:
  void buildBelow(const Range& root) {
    std::vector<Range> open{root};
    while (!open.empty()) {
      const Range range = open.back();
      open.pop_back();
      if (range.count == 1) {
        nodes_[range.node] = {items_[range.first].box, range.first, 1, 0};
        continue;
      }
      const auto [left, right] = split(range, false);
      open.push_back(right);
      open.push_back(left);
    }
  }

  /// Writes the node of a range of two or more items and divides the items.
  std::pair<Range, Range> split(const Range& range, bool parallel) {
    Box box, centroids;
    forChunks(range, parallel, [&](std::uint32_t begin, std::uint32_t end, std::mutex& mutex) {
      Box b, c;
      for (std::uint32_t i = begin; i < end; ++i) {
        b.grow(items_[i].box);
        c.grow(centroid(items_[i].box));
      }
      const std::lock_guard lock(mutex);
      box.grow(b);
      centroids.grow(c);
    });

    const auto begin = items_.begin() + range.first;
    const auto end = begin + range.count;
    auto middle = begin + range.count / 2;
    const Binning binning(centroids);
    const Split best = range.depth < kSahDepth ? cheapestSplit(range, binning, parallel) : Split{};
    if (best.axis >= 0) {
      middle = std::partition(begin, end, [&](const BuildItem& item) {
        return binning.bin(centroid(item.box), best.axis) <= best.bin;
      });
    } else {
      const glm::vec3 extent = centroids.hi - centroids.lo;
      const int axis =
          extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
      std::nth_element(begin, middle, end, [axis](const BuildItem& a, const BuildItem& b) {
        const float ca = centroid(a.box)[axis], cb = centroid(b.box)[axis];
        return ca < cb || (ca == cb && a.id < b.id);
      });
    }

    const auto leftCount = static_cast<std::uint32_t>(middle - begin);
    // A subtree of n items takes 2 n - 1 nodes, so its place is known before it is built.
    const Range left{range.node + 1, range.first, leftCount, range.depth + 1};
    const Range right{range.node + 2 * leftCount, range.first + leftCount, range.count - leftCount,
                      range.depth + 1};
    nodes_[range.node] = {box, range.first, range.count, right.node};
    return {left, right};
  }

  Split cheapestSplit(const Range& range, const Binning& binning, bool parallel) {
    Bins bins;
    forChunks(range, parallel, [&](std::uint32_t begin, std::uint32_t end, std::mutex& mutex) {
      Bins own;
      for (std::uint32_t i = begin; i < end; ++i) {
        const Box& box = items_[i].box;
        const glm::vec3 c = centroid(box);
        for (int a = 0; a < 3; ++a) {
          if (binning.scale[a] <= 0.0F) continue;
          Bin& bin = own[static_cast<std::size_t>(a)][binning.bin(c, a)];
          bin.box.grow(box);
          ++bin.count;
        }
      }
      const std::lock_guard lock(mutex);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t i = 0; i < kBins; ++i) {
          bins[a][i].box.grow(own[a][i].box);
          bins[a][i].count += own[a][i].count;
        }
    });

    Split best;
    float bestCost = std::numeric_limits<float>::infinity();
    for (std::size_t a = 0; a < 3; ++a) {
      if (binning.scale[static_cast<int>(a)] <= 0.0F) continue;
      std::array<float, kBins> rightCost{};
      Box box;
      std::uint32_t count = 0;
      for (std::size_t i = kBins - 1; i > 0; --i) {
        box.grow(bins[a][i].box);
        count += bins[a][i].count;
        rightCost[i] = count == 0 ? -1.0F : box.halfArea() * static_cast<float>(count);
      }
      box = {};
      count = 0;
      for (std::size_t i = 0; i + 1 < kBins; ++i) {
        box.grow(bins[a][i].box);
        count += bins[a][i].count;
        if (count == 0 || rightCost[i + 1] < 0.0F) continue;
        const float cost = box.halfArea() * static_cast<float>(count) + rightCost[i + 1];
        if (cost < bestCost) {
          bestCost = cost;
          best = {static_cast<int>(a), static_cast<unsigned>(i)};
        }
      }
    }
    return best;
  }

  /// Calls f(begin, end, mutex) for pieces of the range; minima, maxima and counts do not depend on
  /// the order of the pieces.
  template <class F>
  void forChunks(const Range& range, bool parallel, const F& f) {
    std::mutex mutex;
    if (!parallel || range.count < kParallelBinning) {
      f(range.first, range.first + range.count, mutex);
      return;
    }
    parallelFor(range.count, kParallelBinning / 2, threads_,
                [&](std::size_t begin, std::size_t end) {
                  f(range.first + static_cast<std::uint32_t>(begin),
                    range.first + static_cast<std::uint32_t>(end), mutex);
                });
  }

  std::vector<BuildItem>& items_;
  unsigned threads_;
  std::vector<BinaryNode> nodes_;
};

}  // namespace

std::vector<BinaryNode> buildBinary(std::vector<BuildItem>& items, unsigned threads) {
  if (items.empty()) return {};
  return Builder(items, threads).build();
}

}  // namespace laver
