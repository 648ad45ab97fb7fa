#include "bvh/small.h"

#include <algorithm>

namespace laver {
namespace {

class SmallSubtree {
 public:
  explicit SmallSubtree(BinaryTree& tree) : tree_(tree) {}

  Forest one(const Subtree& s, const BuildItem& a) {
    tree_.items[s.first] = a;
    return oneItem(a.box.halfArea());
  }

  Forest two(const Subtree& s, const BuildItem& a, const BuildItem& b) {
    tree_.items[s.first] = a;
    tree_.items[s.first + 1] = b;
    const Box4 box = join(a.box, b.box);
    BinaryNode& node = put(s, box, 1);
    return twoItems(box.halfArea(), a.box.halfArea(), b.box.halfArea(), node.choices);
  }

  Forest three(const Subtree& s, const BuildItem& a, const BuildItem& b, const BuildItem& c) {
    const Box4 ab = join(a.box, b.box);
    const Float4 pairs = halfAreas(ab, join(a.box, c.box), join(b.box, c.box));
    const Float4 cost = 2.0F * pairs + halfAreas(c.box, b.box, a.box);
    const Box4 all = join(ab, c.box);
    if (cost[0] <= cost[1] && cost[0] <= cost[2]) return twoAndOne(s, all, a, b, c);
    return cost[1] <= cost[2] ? twoAndOne(s, all, a, c, b) : twoAndOne(s, all, b, c, a);
  }

  Forest four(const Subtree& s, const std::array<BuildItem, 4>& i) {
    const Box4 a = i[0].box, b = i[1].box, c = i[2].box, d = i[3].box;
    const Box4 ab = join(a, b), cd = join(c, d);
    const Float4 halves =
        2.0F * (halfAreas(ab, join(a, c), join(a, d)) + halfAreas(cd, join(b, d), join(b, c)));
    const Float4 threeAndOnes =
        3.0F * halfAreas(join(b, cd), join(a, cd), join(ab, d)) + halfAreas(a, b, c);
    const Box4 abc = join(ab, c);
    const std::array<float, 7> cost{halves[0],
                                    halves[1],
                                    halves[2],
                                    threeAndOnes[0],
                                    threeAndOnes[1],
                                    threeAndOnes[2],
                                    3.0F * abc.halfArea() + d.halfArea()};
    const Box4 all = join(abc, d);
    switch (std::min_element(cost.begin(), cost.end()) - cost.begin()) {
      case 0:
        return twoAndTwo(s, all, i[0], i[1], i[2], i[3]);
      case 1:
        return twoAndTwo(s, all, i[0], i[2], i[1], i[3]);
      case 2:
        return twoAndTwo(s, all, i[0], i[3], i[1], i[2]);
      case 3:
        return threeAndOne(s, all, i[1], i[2], i[3], i[0]);
      case 4:
        return threeAndOne(s, all, i[0], i[2], i[3], i[1]);
      case 5:
        return threeAndOne(s, all, i[0], i[1], i[3], i[2]);
      default:
        return threeAndOne(s, all, i[0], i[1], i[2], i[3]);
    }
  }

 private:
  Forest twoAndOne(const Subtree& s, const Box4& box, const BuildItem& a, const BuildItem& b,
                   const BuildItem& c) {
    BinaryNode& node = put(s, box, 2);
    return joined(two(s.left(2), a, b), 2, one(s.right(2), c), 1, box.halfArea(), node.choices);
  }
  Forest twoAndTwo(const Subtree& s, const Box4& box, const BuildItem& a, const BuildItem& b,
                   const BuildItem& c, const BuildItem& d) {
    BinaryNode& node = put(s, box, 2);
    return joined(two(s.left(2), a, b), 2, two(s.right(2), c, d), 2, box.halfArea(), node.choices);
  }
  Forest threeAndOne(const Subtree& s, const Box4& box, const BuildItem& a, const BuildItem& b,
                     const BuildItem& c, const BuildItem& d) {
    BinaryNode& node = put(s, box, 3);
    return joined(three(s.left(3), a, b, c), 3, one(s.right(3), d), 1, box.halfArea(),
                  node.choices);
  }
  BinaryNode& put(const Subtree& s, const Box4& box, std::uint32_t leftCount) {
    BinaryNode& node = tree_.nodes[s.node];
    node = std::bit_cast<BinaryNode>(box);
    node.leftCount = leftCount;
    return node;
  }

  BinaryTree& tree_;
};

}  // namespace

Forest buildSmall(const BuildItem* items, const Subtree& s, BinaryTree& tree) {
  // A copy, since the items may be in the tree's own memory.
  std::array<BuildItem, kSmallItems> i;
  std::copy_n(items, s.count, i.begin());
  SmallSubtree small(tree);
  switch (s.count) {
    case 1:
      return small.one(s, i[0]);
    case 2:
      return small.two(s, i[0], i[1]);
    case 3:
      return small.three(s, i[0], i[1], i[2]);
    default:
      return small.four(s, i);
  }
}

}  // namespace laver
