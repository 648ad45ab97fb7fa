#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/emitter.h"
#include "reference/texture.h"

namespace laver::reference {

namespace {

constexpr double kPi = std::numbers::pi;

/// Longitude in [0, 2 pi) and colatitude of a direction of the world in the image's space.
glm::dvec2 anglesOf(const Environment& environment, const glm::dvec3& direction) {
  const glm::dvec3 d = glm::inverse(glm::dmat3(environment.toWorld)) * glm::normalize(direction);
  const double longitude = std::atan2(d.x, -d.z);
  return {longitude < 0.0 ? longitude + 2.0 * kPi : longitude,
          std::atan2(std::hypot(d.x, d.z), d.y)};
}

/// The Jacobian determinant of directions from the world to the image's space.
double stretchAt(const Environment& environment, const glm::dvec3& unit) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(environment.toWorld));
  return std::abs(glm::determinant(inverse)) / std::pow(glm::length(inverse * unit), 3);
}

/// Per solid angle of the image's space.
double densityIn(glm::ivec2 grid, int row) {
  const double height = std::cos(kPi * row / grid.y) - std::cos(kPi * (row + 1) / grid.y);
  return grid.x / (2.0 * kPi * height);
}

}  // namespace

glm::dvec3 environment(const Environment& environment, const glm::dvec3& direction) {
  if (!environment.image) return environment.radiance;
  const glm::dvec2 angles = anglesOf(environment, direction);
  return environment.radiance * interpolated(*environment.image, environment.raw,
                                             angles.x / (2 * kPi) * widthOf(*environment.image),
                                             angles.y / kPi * heightOf(*environment.image), false);
}

/// Uniform by solid angle within the cell.
DirectionSample environmentDirection(const Environment& environment, glm::ivec2 grid,
                                     std::size_t cell, glm::dvec2 numbers) {
  const int row = static_cast<int>(cell) / grid.x, column = static_cast<int>(cell) % grid.x;
  const double longitude = 2.0 * kPi * (column + numbers.x) / grid.x;
  const double height =
      glm::mix(std::cos(kPi * row / grid.y), std::cos(kPi * (row + 1) / grid.y), numbers.y);
  const double radius = std::sqrt(std::max(0.0, 1.0 - height * height));
  const glm::dvec3 d(radius * std::sin(longitude), height, -radius * std::cos(longitude));
  const glm::dvec3 unit = glm::normalize(glm::dmat3(environment.toWorld) * d);
  return {unit, densityIn(grid, row) * stretchAt(environment, unit)};
}

CellDensity environmentDensity(const Environment& environment, glm::ivec2 grid,
                               const glm::dvec3& direction) {
  const glm::dvec2 angles = anglesOf(environment, direction);
  const int column = std::min(static_cast<int>(angles.x / (2 * kPi) * grid.x), grid.x - 1);
  const int row = std::min(static_cast<int>(angles.y / kPi * grid.y), grid.y - 1);
  return {static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.x) +
              static_cast<std::size_t>(column),
          densityIn(grid, row) * stretchAt(environment, glm::normalize(direction))};
}

}  // namespace laver::reference
