#include <algorithm>
#include <cmath>

#include "reference/emitter.h"

namespace laver::reference {

LightSample spot(const PointLight& light, const glm::dvec3& from, double) {
  const glm::dvec3 away = from - light.position;
  const double distance = glm::length(away);
  if (distance == 0.0) return {light.position, glm::dvec3(0.0)};
  const glm::dvec3 unit = away / distance;
  const double along = glm::dot(light.axis, unit);
  const double angle = std::atan2(glm::length(glm::cross(light.axis, unit)), along);
  const double inner = glm::radians(light.inner), outer = glm::radians(light.outer);
  // Without an edge, the cone ends at once.
  double share = angle < outer ? 1.0 : 0.0;
  if (inner < outer && light.falloff == Falloff::Angle)
    share = std::clamp((outer - angle) / (outer - inner), 0.0, 1.0);
  else if (inner < outer)
    share = std::clamp((along - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0, 1.0);
  switch (light.falloff) {
    case Falloff::Angle:
      break;
    case Falloff::Square:
      share = share * share;
      break;
    case Falloff::Quartic:
      share = std::pow(share, 4);
      break;
    case Falloff::Projected:
      share = std::pow(share, 4) * std::max(along, 0.0);
  }
  return {light.position, light.radiance * share / (distance * distance)};
}

}  // namespace laver::reference
