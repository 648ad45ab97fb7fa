#include <cmath>
#include <numbers>

#include "reference/emitter.h"
#include "reference/openness.h"
#include "reference/texture.h"

namespace laver::reference {

glm::dvec3 environment(const Environment& environment, const glm::dvec3& direction) {
  if (!environment.image) return environment.radiance;
  const glm::dvec3 d =
      glm::normalize(glm::inverse(glm::dmat3(environment.toWorld)) * glm::normalize(direction));
  constexpr double pi = std::numbers::pi;
  const double longitude = std::atan2(d.x, -d.z);
  const double colatitude = std::atan2(std::hypot(d.x, d.z), d.y);
  return environment.radiance * interpolated(*environment.image, environment.raw,
                                             longitude / (2 * pi) * widthOf(*environment.image),
                                             colatitude / pi * heightOf(*environment.image), false);
}

DirectionSample environmentDirection(const Environment&, glm::dvec2 numbers) {
  return {onSphere(numbers), 0.25 / std::numbers::pi};
}

double environmentDensity(const Environment&, const glm::dvec3&) { return 0.25 / std::numbers::pi; }

}  // namespace laver::reference
