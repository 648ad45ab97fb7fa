#include "bvh/binary.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "bvh/small.h"
#include "bvh/split.h"
#include "core/parallel.h"

namespace laver {
namespace {

/// Items per piece when several threads split one range.
constexpr std::uint32_t kPiece = 1U << 13;

struct Range : Subtree {
  unsigned depth;
  unsigned buffer;  ///< of its items: 0 for the tree's own, 1 for the spare one
};

class Builder {
 public:
  Builder(UninitialisedVector<BuildItem> items, unsigned threads) : threads_(threads) {
    tree_.items = std::move(items);
    tree_.nodes.resize(tree_.items.size() - 1);
    spare_.resize(tree_.items.size());
  }

  BinaryTree build() {
    splitLarge();
    parallelFor(threadCount(threads_), 1, threads_, [this](std::size_t, std::size_t) { work(); });
    std::sort(done_.begin(), done_.end(),
              [](const Done& a, const Done& b) { return a.first < b.first; });
    auto next = done_.cbegin();
    aboveTasks(tree_.root(), next);
    return std::move(tree_);
  }

 private:
  struct Done {
    std::uint32_t first;
    Forest forest;
  };

  BuildItem* itemsOf(const Range& r) {
    return (r.buffer == 0 ? tree_.items : spare_).data() + r.first;
  }
  BuildItem* targetOf(const Range& r) {
    return (r.buffer == 0 ? spare_ : tree_.items).data() + r.first;
  }

  /// Splits ranges larger than a thread's share, one after the other, each with all threads.
  void splitLarge() {
    const std::uint32_t total = tree_.root().count;
    const std::uint32_t large = std::max(total / threadCount(threads_), 2 * kPiece);
    open_.push_back({tree_.root(), 0, 0});
    for (std::size_t i = 0; i < open_.size();) {
      if (threadCount(threads_) == 1 || open_[i].count <= large) {
        ++i;
        continue;
      }
      const auto [left, right] = splitTogether(open_[i]);
      open_[i] = left;
      open_.push_back(right);
    }
  }

  /// Builds open ranges until none is left and no thread can add another.
  void work() {
    for (;;) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !open_.empty() || busy_ == 0; });
      if (open_.empty()) return;
      const Range range = open_.back();
      open_.pop_back();
      ++busy_;
      lock.unlock();
      try {
        buildTask(range);
      } catch (...) {
        finish();
        throw;
      }
      finish();
    }
  }

  void finish() {
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) changed_.notify_all();
  }

  /// Splits a range down to the size of a task, adds the right parts to the open ranges, and builds
  /// the rest.
  void buildTask(Range range) {
    while (range.count > kTaskItems) {
      const auto [left, right] = split(range);
      range = left;
      const std::lock_guard lock(mutex_);
      open_.push_back(right);
      changed_.notify_one();
    }
    const Forest forest = subtree(range);
    const std::lock_guard lock(mutex_);
    done_.push_back({range.first, forest});
  }

  Forest subtree(const Range& range) {
    if (range.count <= kSmallItems && range.depth < kSahDepth)
      return buildSmall(itemsOf(range), range, tree_);
    if (range.count == 1) {
      tree_.items[range.first] = *itemsOf(range);
      return oneItem(tree_.items[range.first].box.halfArea());
    }
    const auto [left, right] = split(range);
    const Forest ofLeft = subtree(left), ofRight = subtree(right);
    return collapsed(range, ofLeft, ofRight);
  }

  /// The costs of the nodes above the tasks; `next` goes through done_ in the order of items.
  Forest aboveTasks(const Subtree& s, std::vector<Done>::const_iterator& next) {
    if (s.count <= kTaskItems) return (next++)->forest;
    const Forest ofLeft = aboveTasks(tree_.left(s), next),
                 ofRight = aboveTasks(tree_.right(s), next);
    return collapsed(s, ofLeft, ofRight);
  }

  Forest collapsed(const Subtree& s, const Forest& ofLeft, const Forest& ofRight) {
    BinaryNode& node = tree_.nodes[s.node];
    return joined(ofLeft, node.leftCount, ofRight, s.count - node.leftCount, node.box().halfArea(),
                  node.choices);
  }

  /// None from a depth on, so that the range is halved.
  static Split bestOf(const Range& range, const Bins& bins, const Binning& binning) {
    return range.depth < kSahDepth ? bins.cheapest(binning) : Split{};
  }

  std::pair<Range, Range> split(const Range& range) {
    const BuildItem* items = itemsOf(range);
    const ItemBounds bounds = boundsOf(items, range.count);
    const Binning binning(bounds.centroids, range.count);
    Bins bins(binning.bins());
    bins.add(binning, items, range.count);
    const Split best = bestOf(range, bins, binning);
    if (best.axis < 0) return halve(range, bounds);
    BuildItem* out = targetOf(range);
    place(items, range.count, binning, best, out, 0, best.leftCount);
    return divided(range, bounds, best.leftCount, range.buffer ^ 1U);
  }

  std::pair<Range, Range> splitTogether(const Range& range) {
    const BuildItem* items = itemsOf(range);
    const std::size_t pieces = (range.count + kPiece - 1) / kPiece;
    const auto forPieces = [&](const auto& f) {
      parallelFor(range.count, kPiece, threads_, [&](std::size_t begin, std::size_t end) {
        f(begin / kPiece, items + begin, static_cast<std::uint32_t>(end - begin));
      });
    };
    std::vector<ItemBounds> boundsOfPiece(pieces);
    forPieces([&](std::size_t piece, const BuildItem* from, std::uint32_t count) {
      boundsOfPiece[piece] = boundsOf(from, count);
    });
    ItemBounds bounds;
    for (const ItemBounds& b : boundsOfPiece) {
      bounds.box.grow(b.box);
      bounds.centroids.grow(b.centroids);
    }
    const Binning binning(bounds.centroids, range.count);
    std::vector<Bins> binsOf(pieces, Bins(binning.bins()));
    forPieces([&](std::size_t piece, const BuildItem* from, std::uint32_t count) {
      binsOf[piece].add(binning, from, count);
    });
    Bins bins(binning.bins());
    for (const Bins& b : binsOf) bins.add(b);
    const Split best = bestOf(range, bins, binning);
    if (best.axis < 0) return halve(range, bounds);
    // Left items before each piece: items keep their order.
    std::vector<std::uint32_t> leftBefore(pieces + 1, 0);
    for (std::size_t i = 0; i < pieces; ++i)
      leftBefore[i + 1] = leftBefore[i] + binsOf[i].upTo(best);
    BuildItem* out = targetOf(range);
    forPieces([&](std::size_t piece, const BuildItem* from, std::uint32_t count) {
      const std::uint32_t left = leftBefore[piece];
      const auto before = static_cast<std::uint32_t>(piece) * kPiece;
      place(from, count, binning, best, out, left, best.leftCount + before - left);
    });
    return divided(range, bounds, best.leftCount, range.buffer ^ 1U);
  }

  /// Moves left items to out[left], … and right items to out[right], …, in their order.
  static void place(const BuildItem* items, std::uint32_t count, const Binning& binning,
                    const Split& split, BuildItem* out, std::uint32_t left, std::uint32_t right) {
    for (std::uint32_t i = 0; i < count; ++i) {
      // Branchless, since the side is unpredictable.
      const std::uint32_t beyond = binning.beyond(items[i], split.axis, split.bin) ? 1 : 0;
      out[left ^ ((left ^ right) & (0U - beyond))] = items[i];
      right += beyond;
      left += 1 - beyond;
    }
  }

  /// At the median of the widest axis; ids break ties.
  std::pair<Range, Range> halve(const Range& range, const ItemBounds& bounds) {
    const Float4 extent = bounds.centroids.hi - bounds.centroids.lo;
    const int axis = extent[0] >= extent[1] ? (extent[0] >= extent[2] ? 0 : 2)
                                            : (extent[1] >= extent[2] ? 1 : 2);
    BuildItem* items = itemsOf(range);
    const std::uint32_t half = range.count / 2;
    std::nth_element(items, items + half, items + range.count,
                     [axis](const BuildItem& a, const BuildItem& b) {
                       const float ca = a.box.lo[axis] + a.box.hi[axis];
                       const float cb = b.box.lo[axis] + b.box.hi[axis];
                       return ca < cb || (ca == cb && a.id() < b.id());
                     });
    return divided(range, bounds, half, range.buffer);
  }

  /// Writes the node of a range and returns its children.
  std::pair<Range, Range> divided(const Range& range, const ItemBounds& bounds,
                                  std::uint32_t leftCount, unsigned buffer) {
    BinaryNode& node = tree_.nodes[range.node];
    node = std::bit_cast<BinaryNode>(bounds.box);
    node.leftCount = leftCount;
    return {{range.left(leftCount), range.depth + 1, buffer},
            {range.right(leftCount), range.depth + 1, buffer}};
  }

  unsigned threads_;
  BinaryTree tree_;
  UninitialisedVector<BuildItem> spare_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Range> open_;
  std::vector<Done> done_;
  unsigned busy_ = 0;
};

}  // namespace

BinaryTree buildBinary(UninitialisedVector<BuildItem> items, unsigned threads) {
  return Builder(std::move(items), threads).build();
}

}  // namespace laver
