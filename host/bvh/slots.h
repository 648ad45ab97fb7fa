#pragma once
#include <array>
#include <span>

#include "bvh/box4.h"
#include "shared/layout.h"

namespace laver {

/// Assigns slots to children so that visiting slot (step ^ octant) in each step goes roughly front
/// to back: the score of a slot is how far the child lies on the sides of the node that the slot's
/// bits name. Greedy over all pairs; Ylitie et al. 2017, section 3.2, solve the same assignment
/// exactly.
std::array<unsigned, shared::NODE_WIDTH> assignSlots(const Box4& box,
                                                     std::span<const Box4> children);

}  // namespace laver
