#include "bvh/portions.h"

#include <algorithm>

namespace laver {
namespace {

class Cutter {
 public:
  Cutter(const Bvh& bvh, std::uint32_t primitives) : bvh_(bvh), max_(primitives) {
    counts_.resize(bvh.nodes.size());
    // A node follows its parent.
    for (std::size_t i = bvh.nodes.size(); i-- > 0;)
      for (const shared::Child& child : bvh.nodes[i].child) counts_[i] += countOf(child);
  }

  Portions run() {
    result_.nodes = bvh_.nodes;
    result_.stack = bvh_.stack + shared::NODE_WIDTH;
    std::vector<std::uint32_t> waiting{bvh_.root};
    while (!waiting.empty()) {
      const shared::Node& node = bvh_.nodes[waiting.back()];
      waiting.pop_back();
      for (const shared::Child& child : node.child) {
        if (child.ref == shared::REF_NONE) continue;
        if (child.ref < shared::REF_LEAF && countOf(child) > max_)
          waiting.push_back(child.ref);
        else
          add(child);
      }
    }
    flush();
    return std::move(result_);
  }

 private:
  std::uint32_t countOf(const shared::Child& child) const {
    if (child.ref == shared::REF_NONE) return 0;
    return child.ref < shared::REF_LEAF ? counts_[child.ref] : child.count;
  }

  /// Adds to the portion that is being filled.
  void add(const shared::Child& child) {
    if (children_ == shared::NODE_WIDTH || filled_ + countOf(child) > max_) flush();
    root_.child[children_++] = child;
    filled_ += countOf(child);
  }

  void flush() {
    if (children_ == 0) return;
    for (; children_ < shared::NODE_WIDTH; ++children_)
      root_.child[children_] = {glm::vec3(0.0F), shared::REF_NONE, glm::vec3(0.0F), 0};
    result_.roots.push_back(static_cast<std::uint32_t>(result_.nodes.size()));
    result_.nodes.push_back(root_);
    children_ = filled_ = 0;
  }

  const Bvh& bvh_;
  std::uint32_t max_;
  std::vector<std::uint32_t> counts_;  ///< primitives below each node
  Portions result_;
  shared::Node root_{};
  std::uint32_t children_ = 0, filled_ = 0;
};

}  // namespace

Portions portionsOf(const Bvh& bvh, std::uint32_t primitives) {
  return Cutter(bvh, primitives).run();
}

}  // namespace laver
