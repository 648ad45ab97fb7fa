#include <algorithm>

#include "bvh/portions.h"
#include "unit/bvh_soup.h"

namespace laver::test {
namespace {

/// The slots of the primitives below a node, in ascending order.
std::vector<std::uint32_t> slotsBelow(const Portions& portions, std::uint32_t root) {
  std::vector<std::uint32_t> slots, waiting{root};
  while (!waiting.empty()) {
    const shared::Node& node = portions.nodes[waiting.back()];
    waiting.pop_back();
    for (const shared::Child& child : node.child) {
      if (child.ref == shared::REF_NONE) continue;
      if (child.ref < shared::REF_LEAF) {
        waiting.push_back(child.ref);
        continue;
      }
      for (std::uint32_t i = 0; i < child.count; ++i)
        slots.push_back((child.ref & shared::REF_INDEX_MASK) + i);
    }
  }
  std::sort(slots.begin(), slots.end());
  return slots;
}

TEST(Portions, HoldEachPrimitiveOnceAndNoMoreThanWanted) {
  for (const std::uint32_t count : {1U, 8U, 9U, 100U, 5000U}) {
    const Bvh bvh = buildBvh(randomTriangles(count, 0.3F), 1);
    for (const std::uint32_t wanted : {shared::MAX_LEAF, 20U, 1024U}) {
      const Portions portions = portionsOf(bvh, wanted);
      std::vector<std::uint32_t> all;
      for (const std::uint32_t root : portions.roots) {
        const std::vector<std::uint32_t> slots = slotsBelow(portions, root);
        EXPECT_LE(slots.size(), wanted);
        EXPECT_FALSE(slots.empty());
        all.insert(all.end(), slots.begin(), slots.end());
      }
      std::sort(all.begin(), all.end());
      ASSERT_EQ(all.size(), count) << wanted;
      for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(all[i], i);
      // Not many more than necessary: two that follow each other hold more than one may.
      EXPECT_LE(portions.roots.size(), 1 + 8 * count / wanted);
    }
  }
}

}  // namespace
}  // namespace laver::test
