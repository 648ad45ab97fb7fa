// A tree deeper than the kernels' first guess of its stack.
#include "reference/reference.h"
#include "render/harness.h"
#include "render/specialise.h"

namespace laver::test {
namespace {

/// Triangles ever smaller and nearer to a point: each split of the tree takes off a few.
Scene spiral() {
  Mesh mesh;
  const auto add = [&](double size, double angle) {
    const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0), side(-out.y, out.x, 0.0);
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (const glm::dvec3& p : {out * 0.9, out + side * 0.3, out - side * 0.3})
      mesh.positions.push_back(glm::dvec3(0.0, 0.0, 5.0) + size * p);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  };
  double size = 1.0;
  for (int i = 0; i < 1200; ++i, size *= 0.97) add(size, 2.4 * i);
  Scene scene;
  scene.integrator = Integrator::Depth;
  scene.meshes = {mesh};
  scene.camera.width = scene.camera.height = 64;
  return scene;
}

TEST(DeepTree, KernelsAreCompiledAnewForItsStack) {
  const Scene scene = spiral();
  const Image truth = Reference(scene).render();
  for (const char* traversal : {"lane", "packet"}) {
    VulkanOptions vulkan = cpuDevice();
    vulkan.traversal = traversal;
    Stats stats;
    const Image image = Renderer(vulkan).render(scene, {}, stats);
    EXPECT_GT(stats.stack, specialise(scene, {})[shared::SPEC_STACK]);
    // One sample a pixel, none of which passes an edge as near as float rounds.
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
      ASSERT_NEAR(image.pixels[i], truth.pixels[i], 1e-5F) << traversal << ' ' << i;
  }
}

}  // namespace
}  // namespace laver::test
