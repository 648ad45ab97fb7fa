#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <random>

#include "scene/scene.h"

namespace laver::test {

/// A camera of `size` x `size` pixels at `origin` that looks along -z with +x to the right and
/// +y up.
inline Camera downCamera(glm::dvec3 origin, double fov, int size) {
  Camera camera;
  camera.toWorld = glm::dmat4(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
                              glm::dvec4(0, 0, -1, 0), glm::dvec4(origin, 1));
  camera.width = camera.height = size;
  camera.fov = fov;
  return camera;
}

/// The square |x|, |y| <= half at height z, its normal +z, in two triangles.
inline Mesh square(double half, double z) {
  Mesh mesh;
  mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  mesh.triangles = {{0, 1, 2}, {2, 3, 0}};
  return mesh;
}

/// A closed surface around 0: rings of vertices whose radii lie in [0.9, 1.1]. With corners less
/// than 0.4 apart in angle its distance from 0 stays above 0.8.
inline Mesh bumpySphere(unsigned rings, unsigned columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.9, 1.1);
  Mesh mesh;
  mesh.positions.emplace_back(0, 0, radius(random));
  for (unsigned i = 1; i < rings; ++i) {
    for (unsigned j = 0; j < columns; ++j) {
      const double theta = std::numbers::pi * i / rings;
      const double phi = 2 * std::numbers::pi * j / columns;
      mesh.positions.push_back(radius(random) * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                           std::sin(theta) * std::sin(phi),
                                                           std::cos(theta)));
    }
  }
  const auto last = static_cast<unsigned>(mesh.positions.size());
  mesh.positions.emplace_back(0, 0, -radius(random));
  const auto at = [&](unsigned i, unsigned j) { return 1 + (i - 1) * columns + j % columns; };
  for (unsigned j = 0; j < columns; ++j) {
    mesh.triangles.emplace_back(0, at(1, j), at(1, j + 1));
    for (unsigned i = 1; i + 1 < rings; ++i) {
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
    mesh.triangles.emplace_back(last, at(rings - 1, j + 1), at(rings - 1, j));
  }
  return mesh;
}

/// Film position of downCamera() that sees a point.
inline glm::dvec2 filmOf(const Camera& camera, glm::dvec3 point) {
  const glm::dvec3 way = point - glm::dvec3(camera.toWorld[3]);
  const double half = std::tan(camera.fov * std::numbers::pi / 360) * -way.z;
  return 0.5 * camera.width * glm::dvec2(1 + way.x / half, 1 - way.y / half);
}

/// A square around 0 at z = 0 seen from (0, 0, 4). One hidden far behind it moves the centre of the
/// meshes away from 0.
inline Scene litSquare() {
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes = {test::square(2, 0), test::square(0.25, -6)};
  scene.meshes[0].bsdf.albedo = {0.2, 0.5, 0.8};
  scene.camera = test::downCamera({0, 0, 4}, 60, 64);
  scene.lights = {{{0, 0, 2}, {4, 8, 12}}};
  return scene;
}

}  // namespace laver::test
