// Point, spot and directional lights.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/pack_parts.h"

namespace laver {
namespace {

using glm::vec3;

std::uint32_t shapeOf(const PointLight& light) {
  if (light.row == &emitters::directional) return shared::LIGHT_DIRECTIONAL;
  if (light.row != &emitters::spot) return shared::LIGHT_POINT;
  switch (light.falloff) {
    case Falloff::Angle:
      break;
    case Falloff::Square:
      return shared::LIGHT_SPOT_SQUARE;
    case Falloff::Quartic:
      return shared::LIGHT_SPOT_QUARTIC;
    case Falloff::Projected:
      return shared::LIGHT_SPOT_PROJECTED;
  }
  return shared::LIGHT_SPOT_ANGLE;
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

double powerOf(const shared::Light& light, double radius) {
  using namespace shared;
  const double bright = glm::dot(glm::dvec3(light.radiance), glm::dvec3(0.2126, 0.7152, 0.0722));
  if (light.shape == LIGHT_DIRECTIONAL) return bright * std::numbers::pi * radius * radius;
  double cosine = -1.0;
  if (light.shape == LIGHT_SPOT_ANGLE)
    cosine = std::cos(2.0 * std::numbers::pi * double{light.outer});
  else if (light.shape != LIGHT_POINT)
    cosine = double{light.outer};
  return bright * 2.0 * std::numbers::pi * (1.0 - cosine);
}

}  // namespace laver
