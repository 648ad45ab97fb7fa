// Every scene of triangles in scenes/ against the double reference, sample by sample; and a vertex
// moved by 16 ulp, to show that the explanation can fail.
#include <gtest/gtest.h>

#include <map>

#include "lab/explain/explain.h"
#include "pictures/harness.h"
#include "reference/reference.h"
#include "render/packed.h"
#include "stability/record.h"
#include "stability/subject.h"

namespace laver::test {
namespace {

/// Flat facets, and one corner of the triangle that most samples meet moved along its normal by 16
/// ulp of a coordinate of 1 in normalised space.
struct Mutation {
  Scene flat, moved;
};

Mutation mutationOf(const Scene& scene) {
  Mutation m{scene, scene};
  for (Scene* s : {&m.flat, &m.moved})
    for (Mesh& mesh : s->meshes) mesh.normals.clear();
  const Reference reference(scene);
  std::map<std::uint32_t, int> samples;
  for (int y = 0; y < scene.camera.height; ++y)
    for (int x = 0; x < scene.camera.width; ++x)
      if (const auto hit = reference.closest(glm::dvec2(x + 0.5, y + 0.5)))
        ++samples[hit->triangle];
  std::uint32_t id = std::max_element(samples.begin(), samples.end(), [](auto& a, auto& b) {
                       return a.second < b.second;
                     })->first;
  std::size_t mesh = 0;
  while (id >= scene.meshes[mesh].triangles.size())
    id -= static_cast<std::uint32_t>(scene.meshes[mesh++].triangles.size());
  auto& positions = m.moved.meshes[mesh].positions;
  const glm::uvec3 t = scene.meshes[mesh].triangles[id];
  const glm::dvec3 normal =
      glm::normalize(glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]));
  positions[t.x] += normal * (16 * 0x1p-24 / normalisationOf(scene).scale);
  return m;
}

LAVER_STABILITY(Explained, "Every scene of triangles against the double reference") {
  for (const std::string& name : sceneNames()) {
    const Scene scene =
        full ? loadScene((scenesFolder() / name).string()).scene : smallScene(name, 192, 1);
    VulkanOptions vulkan;
    vulkan.device = testDevice();
    if (hasSpheres(scene)) {
      EXPECT_THROW(explain(scene, scene, vulkan), Error) << name;  // other cases are of spheres
      continue;
    }
    const Mutation mutation = mutationOf(scene);
    const Explanation wrong = explain(mutation.moved, mutation.flat, vulkan);
    const Explanation e = explain(scene, scene, vulkan);
    record.add({name + ", naive: a vertex moved", "renderer", e.samples,
                static_cast<double>(wrong.unexplained()), static_cast<double>(e.unexplained()), 0.0,
                "unexplained"});
    // One sample in 10,000; a small film may have one or two all the same.
    const auto explained = e.idExplained + e.shadowExplained;
    record.add({name, "renderer", e.samples, std::nullopt, static_cast<double>(explained),
                std::max(2.0, 1e-4 * static_cast<double>(e.samples)), "explained"});
    if (e.unexplained() != 0) ADD_FAILURE() << describe(e);
  }
}

}  // namespace
}  // namespace laver::test
