#include "reference/emitter.h"

namespace laver::reference {

LightSample directional(const PointLight& light, const glm::dvec3& from, double reach) {
  return {from - light.axis * reach, light.radiance};
}

}  // namespace laver::reference
