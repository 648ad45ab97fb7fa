#include "bvh/bvh.h"

#include <fmt/format.h>

#include <algorithm>

#include "bvh/binary.h"
#include "bvh/flatten.h"
#include "core/error.h"
#include "core/parallel.h"
#include "shared/sphere.h"

namespace laver {
namespace {

BuildItem itemOf(const shared::Triangle& t, std::uint32_t number) {
  if (t.flipped == shared::IS_SPHERE) {
    const glm::vec3 reach(t.b.x * shared::SPHERE_GROWTH);
    return {t.a - reach, t.a + reach, number};
  }
  return {glm::min(glm::min(t.a, t.b), t.c), glm::max(glm::max(t.a, t.b), t.c), number};
}

}  // namespace

Bvh buildBvh(std::span<const shared::Triangle> triangles, unsigned threads) {
  if (triangles.empty()) {
    Bvh empty;
    shared::Child none{};
    none.ref = shared::REF_NONE;
    shared::Node root;
    std::fill_n(root.child, shared::NODE_WIDTH, none);
    empty.nodes.push_back(root);
    return empty;
  }
  // An index of all ones would equal REF_NONE.
  if (triangles.size() > shared::REF_INDEX_MASK)
    throw Error(ExitCode::Device, fmt::format("{} triangles; a tree holds at most {}",
                                              triangles.size(), shared::REF_INDEX_MASK));
  UninitialisedVector<BuildItem> items(triangles.size());
  parallelFor(items.size(), 1U << 13, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      items[i] = itemOf(triangles[i], static_cast<std::uint32_t>(i));
  });
  return flatten(buildBinary(std::move(items), threads), triangles, threads);
}

}  // namespace laver
