#pragma once
#include <glm/glm.hpp>
#include <limits>

namespace laver::test {

/// Axis-aligned box; empty when lo > hi.
struct Box {
  glm::vec3 lo{std::numeric_limits<float>::max()};
  glm::vec3 hi{std::numeric_limits<float>::lowest()};

  void grow(glm::vec3 p) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  void grow(const Box& b) {
    lo = glm::min(lo, b.lo);
    hi = glm::max(hi, b.hi);
  }
  bool contains(const Box& b) const {
    return glm::all(glm::lessThanEqual(lo, b.lo)) && glm::all(glm::greaterThanEqual(hi, b.hi));
  }
  /// Half the surface area; 0 for an empty box.
  float halfArea() const {
    const glm::vec3 d = glm::max(hi - lo, glm::vec3(0.0F));
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

}  // namespace laver::test
