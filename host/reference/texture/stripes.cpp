#include "reference/texture.h"

namespace laver::reference {

glm::dvec3 stripes(const Texture& texture, glm::dvec2 st) {
  return texture.colors[static_cast<std::int64_t>(st.x) % 2 == 0 ? 0 : 1];
}

}  // namespace laver::reference
