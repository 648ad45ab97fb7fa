// A tree deeper than the kernels' initial stack.
#include "pictures/harness.h"
#include "reference/reference.h"
#include "render/tiling.h"

namespace laver::test {
namespace {

/// Triangles of growing size behind each other, seen from the small end: on each level of the tree
/// a ray continues into the smallest and leaves the others on its stack.
Scene cone() {
  Mesh mesh;
  double size = 1.0;
  for (int i = 0; i < 900; ++i, size *= 0.987) {
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (const glm::dvec2 p : {glm::dvec2(0.0, 1.0), glm::dvec2(0.9, -0.5), glm::dvec2(-0.9, -0.5)})
      mesh.positions.emplace_back(size * p, 5.0 + size);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  Scene scene;
  scene.integrator = {&integrators::depth};
  scene.meshes = {mesh};
  // All of the film sees the smallest one, through pixels that floats can still tell apart.
  scene.camera.width = scene.camera.height = 4;
  scene.camera.fov = 5e-5;
  return scene;
}

TEST(DeepTree, KernelsAreRecompiledForItsStack) {
  const Scene scene = cone();
  const Image truth = Reference(scene).render().image;
  for (const std::string& traversal : traversals()) {
    Stats stats;
    const Image image = Renderer(onTestDevice(traversal)).render(scene, {}, stats).image;
    EXPECT_GT(stats.stack, choicesOf(scene).pictures.front().key.stack);
    // All rays hit the smallest triangle at depth 5, away from its edges.
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
      ASSERT_NEAR(image.pixels[i], truth.pixels[i], 1e-6F) << traversal << ' ' << i;
  }
}

}  // namespace
}  // namespace laver::test
