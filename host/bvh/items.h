#pragma once
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

#include "bvh/box4.h"

namespace laver {

/// A primitive to be sorted into a tree: its box, with its number in the fourth lane of `lo`.
struct BuildItem {
  Box4 box;

  BuildItem() = default;
  BuildItem(glm::vec3 lo, glm::vec3 hi, std::uint32_t id)
      : box{{lo.x, lo.y, lo.z, std::bit_cast<float>(kOrdinary | id)}, {hi.x, hi.y, hi.z, 0.0F}} {}
  std::uint32_t id() const { return std::bit_cast<std::uint32_t>(box.lo[3]) & ~kOrdinary; }

 private:
  /// Makes the number a normal float, since sums over all lanes would be slow with subnormals.
  static constexpr std::uint32_t kOrdinary = 0x40000000U;
};

}  // namespace laver
