#include "reference/texture.h"

namespace laver::reference {

glm::dvec3 uv(const Texture&, glm::dvec2 st) { return {st, 0.0}; }

}  // namespace laver::reference
