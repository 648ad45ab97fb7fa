#include <cmath>

#include "reference/texture.h"

namespace laver::reference {

glm::dvec3 bitmap(const Texture& texture, glm::dvec2 st) {
  if (!texture.image) return texture.colors[0];
  // The image repeats: only the fractional part matters.
  const double s = st.x - std::floor(st.x), t = st.y - std::floor(st.y);
  const glm::dvec3 shown = interpolated(*texture.image, texture.raw, s * widthOf(*texture.image),
                                        (1.0 - t) * heightOf(*texture.image), true);
  return texture.colors[0] * (texture.red ? glm::dvec3(shown.x) : shown);
}

}  // namespace laver::reference
