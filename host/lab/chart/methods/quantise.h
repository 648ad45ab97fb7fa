#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "bvh/bvh.h"

namespace laver::chart {

/// The tree with its boxes as tight as their triangles, which the builder grows for laver's own
/// test.
Bvh withTightBoxes(Bvh bvh);

/// Nodes of 8 bits a side, rounded outwards: a texel with the origin (floats) and three biased
/// exponents of 8 bits, then 8 texels: lo, hi (8 bits an axis), reference, -. Shaders and host find
/// a side as origin + steps * 2^exponent, rounded once.
std::vector<glm::uvec4> quantised(const Bvh& bvh);

/// A side of a quantised node, as the shader finds it.
glm::vec3 sideOf(const glm::uvec4& head, std::uint32_t steps);

}  // namespace laver::chart
