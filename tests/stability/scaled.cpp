#include "stability/scaled.h"

namespace laver::test {

Scene scaled(Scene scene, double factor) {
  for (Mesh& mesh : scene.meshes)
    for (glm::dvec3& p : mesh.positions) p *= factor;
  scene.camera.toWorld[3] =
      glm::dvec4(glm::dvec3(scene.camera.toWorld[3]) * factor, scene.camera.toWorld[3].w);
  scene.camera.nearClip *= factor;
  scene.camera.farClip *= factor;
  for (PointLight& light : scene.lights) {
    light.position *= factor;
    light.radiance *= factor * factor;
  }
  return scene;
}

void undoScale(const Scene& scene, double factor, Image& image) {
  if (!scene.integrator.is(integrators::depth)) return;
  for (float& value : image.pixels) value = static_cast<float>(static_cast<double>(value) * factor);
}

std::uint64_t naiveLost(const Scene& scene, double factor) {
  std::uint64_t count = 0;
  for (const Mesh& mesh : scene.meshes)
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 a = mesh.positions[t.x];
      const glm::dvec3 n = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
      count += glm::length(n) * factor * factor < 1e-8 ? 1 : 0;
    }
  return count;
}

}  // namespace laver::test
