#include <algorithm>
#include <cmath>

#include "reference/texture.h"

namespace laver::reference {

glm::dvec3 nearest(const Texture& texture, glm::dvec2 st) {
  if (!texture.image) return texture.colors[0];
  const int width = widthOf(*texture.image), height = heightOf(*texture.image);
  const double s = st.x - std::floor(st.x), t = st.y - std::floor(st.y);
  return texture.colors[0] * pixelAt(*texture.image, texture.raw,
                                     std::min(static_cast<int>(s * width), width - 1),
                                     std::min(static_cast<int>(t * height), height - 1));
}

}  // namespace laver::reference
