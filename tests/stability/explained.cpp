// Every scene in scenes/ against the double-precision reference, sample by sample. As a negative
// control, one vertex is moved by 64 ulp.
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

/// The scene with flat facets, and the same with one change to the primitive that most samples hit:
/// a corner moved along its normal by 64 ulp of a coordinate of 1 in normalised space. A sphere's
/// centre is moved by 512 ulp, since spheres have no edges that would tilt their normal. Fewer ulp,
/// such as 16, are within the bounds of large triangles.
struct Mutation {
  Scene flat, moved;
};

std::uint32_t mostSampled(const Scene& scene) {
  const Reference reference(scene);
  std::map<std::uint32_t, int> samples;
  for (int y = 0; y < scene.camera.height; ++y)
    for (int x = 0; x < scene.camera.width; ++x)
      if (const auto hit = reference.closest(glm::dvec2(x + 0.5, y + 0.5)))
        ++samples[hit->triangle];
  return std::max_element(samples.begin(), samples.end(),
                          [](auto& a, auto& b) { return a.second < b.second; })
      ->first;
}

Mutation mutationOf(const Scene& scene) {
  Mutation m{scene, scene};
  for (Scene* s : {&m.flat, &m.moved})
    for (Mesh& mesh : s->meshes) mesh.normals.clear();
  std::size_t number = mostSampled(scene);
  auto mesh = m.moved.meshes.begin();
  for (; number >= mesh->primitives(); ++mesh) number -= mesh->primitives();
  const double ulp = 0x1p-24 / normalisationOf(scene).scale;
  if (mesh->sphere) {
    mesh->sphere->centre.x += 512 * ulp;
    return m;
  }
  auto& positions = mesh->positions;
  const glm::uvec3 t = mesh->triangles[number];
  const glm::dvec3 normal =
      glm::normalize(glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]));
  positions[t.x] += normal * (64 * ulp);
  return m;
}

LAVER_STABILITY(Explained, "Every scene against the double reference") {
  for (const std::string& name : explainedSceneNames()) {
    const Scene scene =
        full ? loadScene((scenesFolder() / name).string()).scene : smallScene(name, 192, 1);
    VulkanOptions vulkan;
    vulkan.device = testDevice();
    const Mutation mutation = mutationOf(scene);
    const Explanation wrong = explain(mutation.moved, mutation.flat, vulkan);
    const Explanation e = explain(scene, scene, vulkan);
    record.add({name + ", naive: geometry moved", "renderer", e.samples,
                static_cast<double>(wrong.unexplained()), static_cast<double>(e.unexplained()), 0.0,
                "unexplained"});
    // At most one sample in 10,000, but a small film may have one or two.
    const auto explained = e.hits.explained + e.occlusion.explained;
    record.add({name, "renderer", e.samples, std::nullopt, static_cast<double>(explained),
                std::max(2.0, 1e-4 * static_cast<double>(e.samples)), "explained"});
    if (e.unexplained() != 0) ADD_FAILURE() << describe(e);
  }
}

}  // namespace
}  // namespace laver::test
