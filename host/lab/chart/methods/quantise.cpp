#include "lab/chart/methods/quantise.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "bvh/walk.h"

namespace laver::chart {
namespace {

struct Box {
  glm::vec3 lo{INFINITY}, hi{-INFINITY};
  void grow(const Box& other) {
    lo = glm::min(lo, other.lo);
    hi = glm::max(hi, other.hi);
  }
};

Box tighten(Bvh& bvh, std::uint32_t ref) {
  Box box;
  if (ref >= shared::REF_LEAF) {
    forEachTriangle(bvh, ref, [&](const shared::Triangle& t) {
      for (const glm::vec3 corner : {t.a, t.b, t.c}) box.grow({corner, corner});
    });
    return box;
  }
  for (shared::Child& child : bvh.nodes[ref].child) {
    if (child.ref == shared::REF_NONE) continue;
    const Box own = tighten(bvh, child.ref);
    child.lo = own.lo;
    child.hi = own.hi;
    box.grow(own);
  }
  return box;
}

/// The power of two with a biased exponent.
float powerOf(std::uint32_t exponent) { return std::bit_cast<float>(exponent << 23); }

/// The number of steps from the origin to the nearest grid plane outside `value`: below it if
/// `lower`, else above. 256 if 255 steps do not suffice.
std::uint32_t stepsTo(float origin, float step, float value, bool lower) {
  const double exact =
      (static_cast<double>(value) - static_cast<double>(origin)) / static_cast<double>(step);
  auto steps = static_cast<std::int64_t>(
      std::clamp(lower ? std::floor(exact) : std::ceil(exact), 0.0, 256.0));
  const auto side = [&] { return origin + static_cast<float>(steps) * step; };
  // The sum is rounded.
  while (lower && steps > 0 && side() > value) --steps;
  while (!lower && steps < 256 && side() < value) ++steps;
  return static_cast<std::uint32_t>(steps);
}

void quantise(const shared::Node& node, std::vector<glm::uvec4>& texels) {
  Box all;
  for (const shared::Child& child : node.child)
    if (child.ref != shared::REF_NONE) all.grow(Box{child.lo, child.hi});
  if (all.lo.x > all.hi.x) all = {glm::vec3(0.0F), glm::vec3(0.0F)};
  glm::uvec4 head(std::bit_cast<std::uint32_t>(all.lo.x), std::bit_cast<std::uint32_t>(all.lo.y),
                  std::bit_cast<std::uint32_t>(all.lo.z), 0);
  glm::uvec3 exponents;
  for (int a = 0; a < 3; ++a) {
    const float extent = std::max(all.hi[a] - all.lo[a], 1e-30F);
    std::uint32_t e = (std::bit_cast<std::uint32_t>(extent / 255.0F) >> 23);
    while (stepsTo(all.lo[a], powerOf(e), all.hi[a], false) > 255) ++e;
    exponents[a] = e;
    head.w |= e << (8 * a);
  }
  texels.push_back(head);
  for (const shared::Child& child : node.child) {
    glm::uvec4 texel(0, 0, child.ref, 0);
    for (int a = 0; a < 3 && child.ref != shared::REF_NONE; ++a) {
      texel.x |= stepsTo(all.lo[a], powerOf(exponents[a]), child.lo[a], true) << (8 * a);
      texel.y |= stepsTo(all.lo[a], powerOf(exponents[a]), child.hi[a], false) << (8 * a);
    }
    texels.push_back(texel);
  }
}

}  // namespace

Bvh withTightBoxes(Bvh bvh) {
  if (!bvh.nodes.empty()) tighten(bvh, bvh.root);
  return bvh;
}

std::vector<glm::uvec4> quantised(const Bvh& bvh) {
  std::vector<glm::uvec4> texels;
  texels.reserve(bvh.nodes.size() * (shared::NODE_WIDTH + 1));
  for (const shared::Node& node : bvh.nodes) quantise(node, texels);
  return texels;
}

glm::vec3 sideOf(const glm::uvec4& head, std::uint32_t steps) {
  glm::vec3 side;
  for (int a = 0; a < 3; ++a)
    side[a] = std::bit_cast<float>(head[a]) +
              static_cast<float>(steps >> (8 * a) & 255U) * powerOf(head.w >> (8 * a) & 255U);
  return side;
}

}  // namespace laver::chart
