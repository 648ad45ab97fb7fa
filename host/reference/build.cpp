#include "reference/build.h"

#include <array>

#include "core/parallel.h"

namespace laver::reference {

namespace {

constexpr std::size_t leafSize = 4;
constexpr std::size_t binCount = 16;
constexpr int medianDepth = 40;

struct Item {
  Box box;
  glm::dvec3 centroid;
  std::uint32_t triangle;
};

// Items [begin, end), whose nodes are the 2 (end - begin) - 1 from `node` on. Subtrees share no
// memory and can be built concurrently.
struct Task {
  std::size_t node, begin, end;
  int depth;
  std::size_t size() const { return end - begin; }
};

// Half the surface area; 0 for the empty box.
double surface(const Box& box) {
  const glm::dvec3 size = glm::max(box.hi - box.lo, glm::dvec3(0.0));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

class Builder {
 public:
  Builder(std::vector<Item>& items, std::vector<Node>& nodes) : items_(items), nodes_(nodes) {}

  // Builds the subtree of `root`, but appends subtrees of at most `small` items to `rest` instead.
  void build(const Task& root, std::size_t small, std::vector<Task>& rest) {
    std::vector<Task> open{root};
    while (!open.empty()) {
      const Task task = open.back();
      open.pop_back();
      if (task.size() <= small) {
        rest.push_back(task);
        continue;
      }
      Node& node = nodes_[task.node];
      for (std::size_t i = task.begin; i < task.end; ++i) node.box.add(items_[i].box);
      if (task.size() <= leafSize) {
        node.count = static_cast<std::uint32_t>(task.size());
        node.next = static_cast<std::uint32_t>(task.begin);
        continue;
      }
      const std::size_t middle = divide(task);
      const std::size_t second = task.node + 2 * (middle - task.begin);
      node.next = static_cast<std::uint32_t>(second);
      open.push_back({second, middle, task.end, task.depth + 1});
      open.push_back({task.node + 1, task.begin, middle, task.depth + 1});
    }
  }

 private:
  // Partitions the task's items into two nonempty parts; returns where the second begins.
  std::size_t divide(const Task& task) {
    Box box;
    for (std::size_t i = task.begin; i < task.end; ++i) box.add(items_[i].centroid);
    const glm::dvec3 size = box.hi - box.lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };

    if (task.depth < medianDepth && size[axis] > 0.0) {
      const auto bin = [&](const Item& item) {
        const double place = (item.centroid[axis] - box.lo[axis]) / size[axis];
        return std::min(static_cast<std::size_t>(place * binCount), binCount - 1);
      };
      const std::size_t cut = cheapestCut(task, bin);
      const auto middle = std::partition(at(task.begin), at(task.end),
                                         [&](const Item& item) { return bin(item) < cut; });
      if (middle != at(task.begin) && middle != at(task.end)) {
        return static_cast<std::size_t>(middle - items_.begin());
      }
    }
    const std::size_t half = task.begin + task.size() / 2;
    std::nth_element(at(task.begin), at(half), at(task.end), [&](const Item& a, const Item& b) {
      return a.centroid[axis] < b.centroid[axis];
    });
    return half;
  }

  // The cut k of minimum cost: bins below k on one side, the others on the other.
  template <typename Bin>
  std::size_t cheapestCut(const Task& task, const Bin& bin) const {
    std::array<Box, binCount> boxes{};
    std::array<std::size_t, binCount> counts{};
    for (std::size_t i = task.begin; i < task.end; ++i) {
      const std::size_t b = bin(items_[i]);
      boxes[b].add(items_[i].box);
      ++counts[b];
    }
    std::array<double, binCount> above{};  // cost of the bins from k on
    Box box;
    std::size_t count = 0;
    for (std::size_t k = binCount - 1; k > 0; --k) {
      box.add(boxes[k]);
      count += counts[k];
      above[k] = surface(box) * static_cast<double>(count);
    }
    box = {};
    count = 0;
    std::size_t best = binCount / 2;
    double bestCost = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < binCount; ++k) {
      box.add(boxes[k - 1]);
      count += counts[k - 1];
      const double cost = surface(box) * static_cast<double>(count) + above[k];
      if (count == 0 || count == task.size() || !(cost < bestCost)) continue;
      best = k;
      bestCost = cost;
    }
    return best;
  }

  std::vector<Item>& items_;
  std::vector<Node>& nodes_;
};

}  // namespace

std::vector<Node> buildTree(std::vector<Triangle>& triangles, unsigned threads) {
  if (triangles.empty()) return {};
  std::vector<Item> items(triangles.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const glm::dvec3& corner : triangles[i].corner) items[i].box.add(corner);
    items[i].centroid = 0.5 * items[i].box.lo + 0.5 * items[i].box.hi;
    items[i].triangle = static_cast<std::uint32_t>(i);
  }
  std::vector<Node> nodes(2 * items.size() - 1);
  Builder builder(items, nodes);
  std::vector<Task> tasks;
  builder.build({0, 0, items.size(), 0}, std::max<std::size_t>(items.size() / 64, 1024), tasks);
  parallelFor(tasks.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Task> rest;
    for (std::size_t i = begin; i < end; ++i) builder.build(tasks[i], 0, rest);
  });

  std::vector<Triangle> sorted;
  sorted.reserve(items.size());
  for (const Item& item : items) sorted.push_back(triangles[item.triangle]);
  triangles = std::move(sorted);
  return nodes;
}

}  // namespace laver::reference
