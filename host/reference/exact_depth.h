#pragma once
#include <array>
#include <glm/glm.hpp>

namespace laver::reference {

using Corners = std::array<glm::dvec3, 3>;

/// A ray from origin + start, a sum that is not rounded.
struct ExactRay {
  glm::dvec3 origin, start, direction;
};

/// Which of two triangles' planes the ray meets first, as -1, 0 or 1, in exact arithmetic on
/// expansions: sums of doubles that do not overlap (Shewchuk, "Adaptive Precision Floating-Point
/// Arithmetic and Fast Robust Geometric Predicates", 1997). 0 also where a plane is parallel to the
/// ray. Coordinates have about the size of the scene: seven factors must neither overflow nor
/// underflow.
int compareDepths(const ExactRay& ray, const Corners& one, const Corners& other);

}  // namespace laver::reference
