#include <cmath>

#include "reference/texture.h"

namespace laver::reference {

namespace {

bool odd(double x) { return std::fmod(std::abs(std::floor(x)), 2.0) == 1.0; }

}  // namespace

glm::dvec3 checker(const Texture& texture, glm::dvec2 st) {
  return texture.colors[odd(st.x) == odd(st.y) ? 0 : 1];
}

}  // namespace laver::reference
