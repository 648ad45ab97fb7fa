#include "stability/scale_scenes.h"

#include <cmath>

#include "support/bumpy_sphere.h"

namespace laver::test {

using glm::dvec3;

static glm::dmat4 lookAt(dvec3 eye, dvec3 target, dvec3 up) {
  const dvec3 z = glm::normalize(target - eye), x = glm::normalize(glm::cross(up, z));
  return {glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
          glm::dvec4(eye, 1.0)};
}

Scene ball() {
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes.push_back(bumpySphere(24, 32, 0.05, dvec3(0.0, 1.0, 0.0)));
  scene.lights = {{dvec3(2.0, 5.0, 3.0), dvec3(60.0)}};
  scene.camera.toWorld = lookAt({0.0, 1.5, 4.0}, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0});
  scene.camera.width = scene.camera.height = 64;
  scene.camera.fov = 40.0;
  scene.camera.farClip = 1e14;
  return scene;
}

Scene onGround(double x, double z, double tilt) {
  Scene scene = ball();
  Mesh ground;
  for (const auto& [u, v] :
       {std::pair(-1, -1), std::pair(-1, 1), std::pair(1, 1), std::pair(1, -1)})
    ground.positions.emplace_back((u + 0.3) * x, (v - 0.4) * z * std::sin(tilt),
                                  (v - 0.4) * z * std::cos(tilt));
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(std::move(ground));
  return scene;
}

Scene withStray(dvec3 place) {
  Scene scene = ball();
  const double size = 0.1 * glm::length(place);
  Mesh stray;
  stray.positions = {place, place + dvec3(size, 0.0, 0.0), place + dvec3(0.0, size, 0.0)};
  stray.triangles = {{0, 1, 2}};
  scene.meshes.push_back(std::move(stray));
  return scene;
}

Scene onSphere(double radius) {
  Scene scene = ball();
  Mesh planet;
  planet.sphere = Sphere{dvec3(0.0, -radius, 0.0), radius};
  scene.meshes.push_back(std::move(planet));
  return scene;
}

Scene onPlanet(double radius) {
  Scene scene = ball();
  Mesh planet = bumpySphere(24, 48, 0.0, dvec3(0.0));
  for (dvec3& p : planet.positions) p = p * radius - dvec3(0.0, radius, 0.0);
  planet.normals.clear();
  scene.meshes.push_back(std::move(planet));
  return scene;
}

Scene seenFromAfar(double k, bool sphere) {
  Scene scene = ball();
  if (sphere) {
    scene.meshes[0] = {};
    scene.meshes[0].sphere = Sphere{dvec3(0.1, 1.0, 0.2), 0.9};
  }
  const dvec3 target(0.0, 1.0, 0.0);
  scene.camera.toWorld = lookAt(target + k * dvec3(0.9, 5.0, 5.0), target, {0.0, 0.0, -1.0});
  scene.camera.fov = 2.0 * glm::degrees(std::atan(std::tan(glm::radians(10.0)) / k));
  return scene;
}

}  // namespace laver::test
