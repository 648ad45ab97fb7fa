#pragma once
#include <array>
#include <span>

#include "bvh/box4.h"
#include "shared/layout.h"

namespace laver {

/// The slot of each child, so that visiting slot (turn ^ octant) at each turn goes front to back: a
/// child wants the slot whose bits tell on which sides of the node it lies. Greedy over all pairs
/// (Ylitie et al. 2017, section 3.2, solve the same assignment exactly).
std::array<unsigned, shared::NODE_WIDTH> assignSlots(const Box4& box,
                                                     std::span<const Box4> children);

}  // namespace laver
