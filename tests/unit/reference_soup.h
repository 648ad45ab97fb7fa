#pragma once
#include <random>
#include <vector>

#include "reference/triangle.h"
#include "scene/scene.h"

namespace laver::test {

using namespace reference;

/// A mesh's triangles, numbered in order.
inline std::vector<Triangle> trianglesOf(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (const glm::uvec3& t : mesh.triangles) {
    triangles.emplace_back(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z],
                           static_cast<std::uint32_t>(triangles.size()));
  }
  return triangles;
}

/// Uniform random numbers, points of the cube |x|, |y|, |z| <= size, and indices below a count.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(engine_);
  }
  glm::dvec3 point(double size) {
    const double x = number(-size, size), y = number(-size, size);
    return {x, y, number(-size, size)};
  }
  std::size_t index(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }

 private:
  std::mt19937 engine_;
};

/// Random triangles whose corners differ by up to `size` per component from points of the unit
/// cube.
inline std::vector<Triangle> soup(Random& random, unsigned count, double size) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 a = random.point(1), b = a + random.point(size);
    triangles.emplace_back(a, b, a + random.point(size), i);
  }
  return triangles;
}

}  // namespace laver::test
