#include <cmath>
#include <numbers>

#include "reference/emitter.h"

namespace laver::reference {

namespace {

glm::dvec3 axisOf(const Environment& environment) {
  return glm::normalize(glm::dmat3(environment.toWorld) * glm::dvec3(0.0, 0.0, 1.0));
}

double halfAngle(const Environment& environment) {
  return environment.angle * std::numbers::pi / 360.0;
}

/// 1 - cos(angle).
double heightOf(const Environment& environment) {
  return 2.0 * std::sin(halfAngle(environment)) * std::sin(halfAngle(environment));
}

bool onDisk(const Environment& environment, const glm::dvec3& direction) {
  const glm::dvec3 axis = axisOf(environment), unit = glm::normalize(direction);
  const double half = std::atan2(glm::length(unit - axis), glm::length(unit + axis));
  return half <= halfAngle(environment);
}

}  // namespace

glm::dvec3 distantdisk(const Environment& environment, const glm::dvec3& direction) {
  return onDisk(environment, direction) ? environment.radiance : glm::dvec3(0.0);
}

/// Uniform in the cap. The azimuth is measured in the frame of Duff et al., "Building an
/// Orthonormal Basis, Revisited" (2017).
DirectionSample distantdiskDirection(const Environment& environment, glm::ivec2, std::size_t,
                                     glm::dvec2 numbers) {
  const glm::dvec3 n = axisOf(environment);
  const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
  const glm::dvec3 tangent(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
  const glm::dvec3 bitangent(b, sign + n.y * n.y * a, -n.y);
  const double below = numbers.x * heightOf(environment), height = 1.0 - below;
  const double radius = std::sqrt(below * (2.0 - below));
  const double azimuth = 2.0 * std::numbers::pi * numbers.y;
  return {tangent * (radius * std::cos(azimuth)) + bitangent * (radius * std::sin(azimuth)) +
              n * height,
          0.5 / std::numbers::pi / heightOf(environment)};
}

CellDensity distantdiskDensity(const Environment& environment, glm::ivec2,
                               const glm::dvec3& direction) {
  return {0, onDisk(environment, direction) ? 0.5 / std::numbers::pi / heightOf(environment) : 0.0};
}

}  // namespace laver::reference
