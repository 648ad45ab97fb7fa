#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "bvh/bvh.h"

namespace laver::chart {

/// The tree with tight boxes instead of those that the builder has grown for laver's test.
Bvh withTightBoxes(Bvh bvh);

/// Nodes with 8 bits per box bound, rounded outwards: a texel with the origin (floats) and three
/// biased exponents of 8 bits, then 8 texels: lo, hi (8 bits per axis), reference, unused. A bound
/// is origin + steps * 2^exponent, rounded once.
std::vector<glm::uvec4> quantised(const Bvh& bvh);

/// A box bound of a quantised node, computed as in the shader.
glm::vec3 sideOf(const glm::uvec4& head, std::uint32_t steps);

}  // namespace laver::chart
