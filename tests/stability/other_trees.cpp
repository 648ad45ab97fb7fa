#include "stability/other_trees.h"

#include <algorithm>

namespace laver::test {

Bvh withShuffledChildren(Bvh bvh, std::mt19937& random) {
  for (shared::Node& node : bvh.nodes)
    std::shuffle(std::begin(node.child), std::end(node.child), random);
  return bvh;
}

Bvh fromShuffledTriangles(std::span<const shared::Triangle> from, std::mt19937& random) {
  std::vector<shared::Triangle> triangles(from.begin(), from.end());
  std::shuffle(triangles.begin(), triangles.end(), random);
  return buildBvh(triangles);
}

Bvh withTwoChildren(const Bvh& bvh) {
  Bvh two = bvh;
  const shared::Child none{glm::vec3(0.0F), shared::REF_NONE, glm::vec3(0.0F), 0};
  for (std::size_t n = 0; n < bvh.nodes.size(); ++n) {
    std::vector<shared::Child> children;
    for (const shared::Child& child : bvh.nodes[n].child)
      if (child.ref != shared::REF_NONE) children.push_back(child);
    // Moves the last two children into a new node, until two are left.
    while (children.size() > 2) {
      const shared::Child a = children.back(), b = children[children.size() - 2];
      children.resize(children.size() - 2);
      shared::Node node;
      std::fill(std::begin(node.child), std::end(node.child), none);
      node.child[0] = a;
      node.child[1] = b;
      children.push_back({glm::min(a.lo, b.lo), static_cast<std::uint32_t>(two.nodes.size()),
                          glm::max(a.hi, b.hi), 0});
      two.nodes.push_back(node);
    }
    std::fill(std::begin(two.nodes[n].child), std::end(two.nodes[n].child), none);
    std::copy(children.begin(), children.end(), std::begin(two.nodes[n].child));
  }
  two.stack = 8 * bvh.stack + 8;  // an upper bound
  return two;
}

}  // namespace laver::test
