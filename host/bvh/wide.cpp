#include "bvh/wide.h"

#include <algorithm>
#include <limits>

#include "bvh/box4.h"

namespace laver {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

Forest oneItem(float area) {
  Forest forest;
  forest.cost.fill(area * kTriangleCost);
  return forest;
}

Forest twoItems(float area, float left, float right, CollapseChoices& choices) {
  const float apart = left * kTriangleCost + right * kTriangleCost;
  const float leaf = area * 2.0F * kTriangleCost, inner = apart + area * kNodeCost;
  Forest forest;
  forest.cost.fill(std::min({leaf, inner, apart}));
  forest.cost[0] = std::min(leaf, inner);
  choices.nibbles = (inner < leaf ? 1U : 0U) | (apart < forest.cost[0] ? 1U << 4 : 0U);
  return forest;
}

Forest joined(const Forest& left, std::uint32_t leftCount, const Forest& right,
              std::uint32_t rightCount, float area, CollapseChoices& choices) {
  static_assert(shared::NODE_WIDTH == 8);
  // Lane t - 1 of (low, high): the minimum cost of t trees; of (lowLeft, highLeft): the left
  // child's share of them.
  Float4 low = splat(kInfinity), high = low;
  Int4 lowLeft{1, 1, 1, 1}, highLeft = lowLeft;
  const auto& r = right.cost;
  Float4 rightLow{r[0], r[1], r[2], r[3]}, rightHigh{r[4], r[5], r[6], r[7]};
  const unsigned maxTrees = std::min(leftCount, shared::NODE_WIDTH - 1);
  for (unsigned k = 1; k <= maxTrees; ++k) {
    rightHigh = __builtin_shufflevector(rightHigh, rightLow, 7, 0, 1, 2);
    rightLow = __builtin_shufflevector(rightLow, splat(kInfinity), 4, 0, 1, 2);
    const Float4 leftCost = splat(left.cost[k - 1]);
    const Float4 a = leftCost + rightLow, b = leftCost + rightHigh;
    const auto share = static_cast<std::int32_t>(k);
    const Int4 shares{share, share, share, share};
    lowLeft = a < low ? shares : lowLeft;
    highLeft = b < high ? shares : highLeft;
    low = min(a, low);
    high = min(b, high);
  }
  const std::uint32_t count = leftCount + rightCount;
  const float leaf =
      count <= shared::MAX_LEAF ? area * static_cast<float>(count) * kTriangleCost : kInfinity;
  const float inner = high[3] + area * kNodeCost;
  Forest forest;
  forest.cost[0] = std::min(inner, leaf);
  // Costs of huge boxes may both be infinite.
  std::uint32_t nibbles =
      inner < leaf || count > shared::MAX_LEAF ? static_cast<std::uint32_t>(highLeft[3]) : 0;
  for (unsigned i = 1; i < shared::NODE_WIDTH; ++i) {
    const float cost = i < 4 ? low[i] : high[i - 4];
    const auto k = static_cast<std::uint32_t>(i < 4 ? lowLeft[i] : highLeft[i - 4]);
    const bool fewer = forest.cost[i - 1] <= cost;
    forest.cost[i] = fewer ? forest.cost[i - 1] : cost;
    nibbles |= (fewer ? 0U : k) << 4 * i;
  }
  choices.nibbles = nibbles;
  return forest;
}

}  // namespace laver
