#include "lab/explain/numbered.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace laver {
namespace {

/// Triangle k = i * side + j has azimuth (i + 1/2) / side of a right angle and height
/// (j + 1/2) / side: all components positive, cells of equal area, 1e-3 wide for a million.
std::uint32_t sideOf(const Scene& scene) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.triangles.size();
  return static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
}

glm::dvec3 normalOf(std::uint32_t number, std::uint32_t side) {
  const std::uint32_t i = number / side, j = number % side;
  const double azimuth = (i + 0.5) / side * 0.5 * std::numbers::pi;
  const double z = (j + 0.5) / side;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

}  // namespace

Scene numbered(const Scene& scene) {
  Scene result = scene;
  result.integrator = {&integrators::normals};
  const std::uint32_t side = sideOf(scene);
  std::uint32_t number = 0;
  for (Mesh& mesh : result.meshes) {
    Mesh split;
    split.bsdf = mesh.bsdf;
    for (const glm::uvec3& t : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(split.positions.size());
      for (int corner = 0; corner < 3; ++corner) {
        split.positions.push_back(mesh.positions[t[corner]]);
        split.normals.push_back(normalOf(number, side));
      }
      split.triangles.emplace_back(first, first + 1, first + 2);
      ++number;
    }
    mesh = std::move(split);
  }
  return result;
}

std::optional<std::uint32_t> numberOf(const Scene& scene, glm::dvec3 pixel) {
  if (pixel == glm::dvec3(0.0)) return {};
  const double side = sideOf(scene);
  const auto cell = [&](double x) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(x * side), 0.0, side - 1.0));
  };
  const double azimuth = std::atan2(pixel.y, pixel.x) / (0.5 * std::numbers::pi);
  return cell(azimuth) * static_cast<std::uint32_t>(side) + cell(pixel.z);
}

}  // namespace laver
