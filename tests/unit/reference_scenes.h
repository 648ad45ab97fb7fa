#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

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

/// Film position at which downCamera() sees a point.
inline glm::dvec2 filmOf(const Camera& camera, glm::dvec3 point) {
  const glm::dvec3 direction = point - glm::dvec3(camera.toWorld[3]);
  const double half = std::tan(camera.fov * std::numbers::pi / 360) * -direction.z;
  return 0.5 * camera.width * glm::dvec2(1 + direction.x / half, 1 - direction.y / half);
}

/// A square around 0 at z = 0, seen from (0, 0, 4). A hidden square far behind it moves the centre
/// of the meshes away from 0.
inline Scene litSquare() {
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes = {test::square(2, 0), test::square(0.25, -6)};
  scene.meshes[0].bsdf.set("albedo", glm::dvec3(0.2, 0.5, 0.8));
  scene.camera = downCamera({0, 0, 4}, 60, 64);
  scene.lights = {{{0, 0, 2}, {4, 8, 12}}};
  return scene;
}

}  // namespace laver::test
