#include "reference/emitter.h"

namespace laver::reference {

LightSample point(const PointLight& light, const glm::dvec3& from, double) {
  const glm::dvec3 toLight = light.position - from;
  const double squared = glm::dot(toLight, toLight);
  return {light.position, squared == 0.0 ? glm::dvec3(0.0) : light.radiance / squared};
}

}  // namespace laver::reference
