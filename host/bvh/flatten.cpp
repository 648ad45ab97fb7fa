#include "bvh/flatten.h"

#include <algorithm>
#include <array>

#include "bvh/slots.h"
#include "core/parallel.h"

namespace laver {
namespace {

using shared::NODE_WIDTH;

/// The next smaller float; finite numbers only.
Float4 nextDown(Float4 x) {
  constexpr std::int32_t kSign = std::numeric_limits<std::int32_t>::min();
  const Int4 bits = std::bit_cast<Int4>(x);
  return std::bit_cast<Float4>(x > 0.0F ? bits - 1 : (bits | kSign) + 1);
}

/// Grows a box by 1 ulp and 1e-18 on each side, so that the rounding of a reciprocal loses no ray.
Box4 padded(const Box4& box) { return {nextDown(box.lo - 1e-18F), -nextDown(-(box.hi + 1e-18F))}; }

/// Totals of a subtree: depth, maximum stack, counts, and SAH cost times area.
struct Totals {
  std::uint32_t nodes = 0, leaves = 0, depth = 0, stack = 1;
  double cost = 0;
  void add(const Totals& t) {
    nodes += t.nodes;
    leaves += t.leaves;
    depth = std::max(depth, t.depth);
    stack = std::max(stack, t.stack);
    cost += t.cost;
  }
};

/// A wide node with its depth and the number of stack entries when it is popped.
struct Place {
  Subtree tree;
  std::uint32_t depth = 1, stack = 1;
};

/// Up to eight children of a wide node, in the order of the binary tree.
struct Children {
  std::array<Subtree, NODE_WIDTH> tree;
  std::array<bool, NODE_WIDTH> leaf;
  unsigned count = 0;
};

class Flattener {
 public:
  Flattener(const BinaryTree& tree, std::span<const shared::Triangle> triangles, unsigned threads)
      : tree_(tree), triangles_(triangles), threads_(threads) {}

  Bvh flatten() {
    bvh_.triangles.resize(triangles_.size());
    const Subtree root = tree_.root();
    const double area = static_cast<double>(tree_.box(root).halfArea());
    Totals totals;
    bvh_.root = 0;
    totals = nodes(root);
    bvh_.depth = totals.depth;
    bvh_.stack = totals.stack;
    bvh_.leaves = totals.leaves;
    bvh_.sahCost = totals.cost / std::max(area, 1e-300);
    return std::move(bvh_);
  }

 private:
  /// A subtree that one thread writes, its nodes from `first` on.
  struct Task {
    Place place;
    std::uint32_t first = 0;
    Totals totals;
  };

  Totals nodes(const Subtree& root) {
    findTasks({root});
    parallelFor(tasks_.size(), 1, threads_, [this](std::size_t i, std::size_t) {
      tasks_[i].totals.nodes = countNodes(tasks_[i].place.tree);
    });
    std::uint32_t count = topNodes_;
    for (const Task& task : tasks_) count += task.totals.nodes;
    bvh_.nodes.resize(count);
    std::uint32_t next = 0;
    std::size_t task = 0;
    Totals totals;
    const auto isTask = [&](const Place& place) {
      if (place.tree.count > kTaskItems) return false;
      tasks_[task].first = next;
      next += tasks_[task++].totals.nodes;
      return true;
    };
    if (!isTask({root})) write({root}, next, totals, isTask);
    parallelFor(tasks_.size(), 1, threads_, [this](std::size_t i, std::size_t) {
      Task& t = tasks_[i];
      t.totals = {};
      write(t.place, t.first, t.totals, [](const Place&) { return false; });
    });
    for (const Task& t : tasks_) totals.add(t.totals);
    return totals;
  }

  void findTasks(const Place& place) {
    if (place.tree.count <= kTaskItems) {
      tasks_.push_back({place, 0, {}});
      return;
    }
    ++topNodes_;
    const Children children = childrenOf(place.tree);
    for (unsigned c = 0; c < children.count; ++c)
      if (!children.leaf[c]) findTasks(below(place, children, c));
  }

  std::uint32_t countNodes(const Subtree& tree) const {
    const Children children = childrenOf(tree);
    std::uint32_t count = 1;
    for (unsigned c = 0; c < children.count; ++c)
      if (!children.leaf[c]) count += countNodes(children.tree[c]);
    return count;
  }

  /// Visiting a node pops one entry and pushes at most all its children, so the stack never holds
  /// more than 1 + the sum of (children - 1) along a path.
  static Place below(const Place& place, const Children& children, unsigned c) {
    return {children.tree[c], place.depth + 1, place.stack + children.count - 1};
  }

  bool isLeaf(const Subtree& s) const {
    return s.count == 1 || tree_.nodes[s.node].choices.left(1) == 0;
  }

  /// The root is always a node; if it would best be a leaf, it has that leaf as only child.
  Children childrenOf(const Subtree& s) const {
    Children children;
    if (isLeaf(s)) return {{s}, {true}, 1};
    const unsigned left = tree_.nodes[s.node].choices.left(1);
    expand(tree_.left(s), left, children);
    expand(tree_.right(s), NODE_WIDTH - left, children);
    return children;
  }

  void expand(const Subtree& s, unsigned trees, Children& children) const {
    if (s.count > 1) {
      const CollapseChoices choices = tree_.nodes[s.node].choices;
      while (trees > 1 && choices.left(trees) == 0) --trees;
      if (trees > 1) {
        const unsigned left = choices.left(trees);
        expand(tree_.left(s), left, children);
        expand(tree_.right(s), trees - left, children);
        return;
      }
    }
    children.tree[children.count] = s;
    children.leaf[children.count++] = isLeaf(s);
  }

  /// Writes a wide node and those below it, from `next` on, except subtrees for which `elsewhere`
  /// returns true.
  template <class F>
  void write(const Place& place, std::uint32_t& next, Totals& totals, const F& elsewhere) {
    const Children children = childrenOf(place.tree);
    prefetchTriangles(children);
    const Box4 box = tree_.box(place.tree);
    std::array<Box4, NODE_WIDTH> boxes;
    for (unsigned c = 0; c < children.count; ++c) boxes[c] = tree_.box(children.tree[c]);
    const auto slotOf = assignSlots(box, {boxes.data(), children.count});
    shared::Node& node = bvh_.nodes[next++];
    for (shared::Child& child : node.child)
      child = {glm::vec3(0.0F), shared::REF_NONE, glm::vec3(0.0F), 0};
    totals.add({1, 0, place.depth, place.stack + children.count - 1,
                static_cast<double>(kNodeCost * box.halfArea())});
    for (unsigned c = 0; c < children.count; ++c) {
      const Subtree& tree = children.tree[c];
      shared::Child& child = node.child[slotOf[c]];
      child = std::bit_cast<shared::Child>(padded(boxes[c]));
      child.count = children.leaf[c] ? tree.count : 0;
      if (children.leaf[c]) {
        child.ref = shared::REF_LEAF | (tree.count - 1) << shared::REF_COUNT_SHIFT | tree.first;
        totals.add(leaf(tree));
      } else {
        child.ref = next;
        const Place inner = below(place, children, c);
        if (!elsewhere(inner)) write(inner, next, totals, elsewhere);
      }
    }
  }

  /// Prefetches the triangles, which are scattered in memory.
  void prefetchTriangles(const Children& children) const {
    for (unsigned c = 0; c < children.count; ++c)
      for (std::uint32_t i = 0; children.leaf[c] && i < children.tree[c].count; ++i)
        __builtin_prefetch(&triangles_[tree_.items[children.tree[c].first + i].id()]);
  }

  Totals leaf(const Subtree& s) {
    for (std::uint32_t i = 0; i < s.count; ++i) {
      shared::Triangle& triangle = bvh_.triangles[s.first + i];
      triangle = triangles_[tree_.items[s.first + i].id()];
      triangle.more = s.count - 1 - i;
    }
    const float area = tree_.box(s).halfArea();
    return {0, 1, 0, 1, static_cast<double>(kTriangleCost * static_cast<float>(s.count) * area)};
  }

  const BinaryTree& tree_;
  std::span<const shared::Triangle> triangles_;
  unsigned threads_;
  Bvh bvh_;
  std::vector<Task> tasks_;
  std::uint32_t topNodes_ = 0;  ///< number of wide nodes above all tasks
};

}  // namespace

Bvh flatten(const BinaryTree& tree, std::span<const shared::Triangle> triangles, unsigned threads) {
  return Flattener(tree, triangles, threads).flatten();
}

}  // namespace laver
