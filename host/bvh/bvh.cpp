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

/// A primitive's box, grown by what its own size adds to the error of tests (shared/box.h).
BuildItem itemOf(const shared::Triangle& t, std::uint32_t number) {
  glm::vec3 lo = glm::min(glm::min(t.a, t.b), t.c), hi = glm::max(glm::max(t.a, t.b), t.c);
  if (t.flipped == shared::IS_SPHERE) {
    const glm::vec3 reach(t.b.x * shared::SPHERE_GROWTH);
    lo = t.a - reach;
    hi = t.a + reach;
  }
  const glm::vec3 largest = glm::max(glm::abs(lo), glm::abs(hi));
  const glm::vec3 pad(shared::BOX_GROWTH * std::max({largest.x, largest.y, largest.z}));
  return {lo - pad, hi + pad, number};
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
