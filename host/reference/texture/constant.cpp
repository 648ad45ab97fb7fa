#include "reference/texture.h"

namespace laver::reference {

glm::dvec3 constant(const Texture& texture, glm::dvec2) { return texture.colors[0]; }

}  // namespace laver::reference
