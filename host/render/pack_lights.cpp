// Point, spot and directional lights.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/pack_parts.h"

namespace laver {
namespace {

using glm::dvec3;
using glm::vec3;

std::uint32_t shapeOf(const PointLight& light) {
  if (light.row == &emitters::directional) return shared::LIGHT_DIRECTIONAL;
  if (light.row != &emitters::spot) return shared::LIGHT_POINT;
  return shared::LIGHT_SPOT_ANGLE + static_cast<std::uint32_t>(light.falloff);
}

}  // namespace

// radiance / distance^2 is invariant if distances are scaled by s and radiance by s^2.
shared::Light packedLight(const PointLight& light, const Normalisation& space) {
  const std::uint32_t shape = shapeOf(light);
  const double squared = shape == shared::LIGHT_DIRECTIONAL ? 1.0 : space.scale * space.scale;
  const auto measure = [&](double degrees) {
    return shape == shared::LIGHT_SPOT_ANGLE ? -degrees / 360.0 : std::cos(glm::radians(degrees));
  };
  const double outer = measure(light.outer);
  // An edge of no width: a step within rounding.
  const double ramp = 1.0 / std::max(measure(light.inner) - outer, 0x1p-100);
  return {
      vec3(space.apply(light.position)), static_cast<float>(outer), vec3(light.radiance * squared),
      static_cast<float>(ramp),          vec3(light.axis),          shape};
}

double powerOf(const PointLight& light, double radius) {
  const double bright = glm::dot(light.radiance, dvec3(0.2126, 0.7152, 0.0722));
  if (light.row == &emitters::directional) return bright * std::numbers::pi * radius * radius;
  const double cosine = light.row == &emitters::spot ? std::cos(glm::radians(light.outer)) : -1.0;
  return bright * 2.0 * std::numbers::pi * (1.0 - cosine);
}

}  // namespace laver
