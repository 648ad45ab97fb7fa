// Input near the limits of lavapipe; what is slow has the label full.
#include <algorithm>

#include "pictures/harness.h"
#include "reference/reference.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

TEST(FullBig, TenMillionTriangles) {
  // Half a gigabyte of triangles, read through texel buffers, since no storage buffer range is that
  // large.
  Scene scene;
  scene.integrator = {&integrators::depth};
  scene.meshes = {bumpySphere(2240, 2240, 0.05, glm::dvec3(0.0, 0.0, 4.0))};
  ASSERT_GT(scene.meshes[0].triangles.size(), 10000000U);
  scene.camera.width = scene.camera.height = 64;
  Stats stats;
  const Image image = Renderer(onTestDevice()).render(scene, {}, stats).image;
  EXPECT_EQ(stats.triangles, scene.meshes[0].triangles.size());
  // The sphere's nearest point is 3 units away, within its bumps of 0.05.
  EXPECT_NEAR(image.at(32, 32, 0), 1.0F / 3.0F, 0.01F);
  EXPECT_EQ(image.at(0, 0, 0), 0.0F);
}

TEST(FullBig, SixtyFiveThousandSamplesPerPixel) {
  const Scene scene = smallScene("cornell-two-lights.xml", 4, 65536);
  const Image image = render(scene), truth = Reference(scene).render().image;
  // A sample that differs at an edge weighs 1 / 65536 of a pixel; a lost batch would exceed the
  // bound.
  for (std::size_t i = 0; i < truth.pixels.size(); ++i)
    EXPECT_NEAR(image.pixels[i], truth.pixels[i], 1e-4F);
}

// More workgroups of one pixel than a dispatch may have side by side. lavapipe runs them all the
// same; the validation layer does not let them pass.
TEST(WideFilms, HaveAllTheirColumns) {
  Scene scene;
  scene.meshes = {quad({{{-9, -9, 3}, {-9, 9, 3}, {9, 9, 5}, {9, -9, 5}}}, {0.5, 0.5, 0.5})};
  scene.lights = {{glm::dvec3(0.0), glm::dvec3(30.0)}};
  scene.integrator = {&integrators::directWhitted};
  scene.camera.width = 140000;
  scene.camera.height = 1;
  scene.camera.fov = 90.0;
  scene.sampler.sampleCount = 64;  // side by side: a workgroup for each pixel
  for (const std::string& traversal : {traversals().front(), traversals().back()}) {
    VulkanOptions vulkan = onTestDevice(traversal);
    vulkan.validate = true;
    const Image whole = render(scene, vulkan);
    for (const int x : {0, 65500, 131000, 139900}) {
      RenderOptions options;
      options.crop = Crop{x, 0, x + 100, 1};
      const Image part = render(scene, onTestDevice(traversal), options);
      for (int i = 0; i < 100; ++i) {
        ASSERT_GT(part.at(i, 0, 0), 0.0F);
        ASSERT_EQ(part.at(i, 0, 0), whole.at(x + i, 0, 0)) << traversal << ' ' << x + i;
      }
    }
  }
}

TEST(FullBig, AFilmOf16384Pixels) {
  // Renders the last rows only; the whole film differs only in its number of bands.
  Scene scene;
  scene.meshes = {bumpySphere(60, 90, 0.05, glm::dvec3(0.0, 0.0, 3.0))};
  scene.camera.width = scene.camera.height = 16384;
  scene.camera.fov = 20.0;
  RenderOptions options;
  options.crop = Crop{0, 16000, 16384, 16384};
  const Image image = render(scene, onTestDevice(), options);
  EXPECT_EQ(image.height, 384);
  EXPECT_TRUE(std::all_of(image.pixels.begin(), image.pixels.end(),
                          [](float v) { return v > 0.0F || v == 0.0F; }));
  EXPECT_GT(
      std::count_if(image.pixels.begin(), image.pixels.end(), [](float v) { return v > 0.1F; }),
      1000000);
}

}  // namespace
}  // namespace laver::test
