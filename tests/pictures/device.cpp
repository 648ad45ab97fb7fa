// Limits and errors of the Vulkan path.
#include <algorithm>
#include <cmath>

#include "pictures/harness.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

TEST(Device, AnUnknownNameIsAnErrorThatListsTheDevices) {
  VulkanOptions vulkan;
  vulkan.device = "no such device";
  try {
    render(Scene{}, vulkan);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::Device);
    const std::string text = error.what();
    EXPECT_NE(text.find("no usable Vulkan device matches \"no such device\"; there are 0: "),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
  }
}

TEST(Device, AnUnknownTraversalIsAUsageError) {
  VulkanOptions vulkan = onTestDevice();
  vulkan.traversal = "magic";
  try {
    render(Scene{}, vulkan);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::Usage);
  }
}

TEST(Device, AFlatFieldIsFlatWithEveryFilter) {
  // A plane that fills the film: |normal| = (0, 0, 1), so blue is sum w / sum w.
  Mesh plane;
  plane.positions = {{-9, -9, 5}, {9, -9, 5}, {9, 9, 5}, {-9, 9, 5}};
  plane.triangles = {{0, 1, 2}, {3, 0, 2}};
  Scene scene;
  scene.meshes = {plane};
  scene.camera.width = 67;
  scene.camera.height = 45;
  scene.sampler.sampleCount = 3;
  for (const FilterRow* kind :
       {&filters::gaussian, &filters::mitchell, &filters::tent, &filters::box}) {
    scene.filter.row = kind;
    scene.filter.radius = kind == &filters::box ? 0.5 : kind == &filters::tent ? 1.0 : 2.0;
    const Image image = render(scene);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        EXPECT_EQ(image.at(x, y, 0), 0.0F);
        // Numerator and denominator are sums of the same products: equal up to the last rounding.
        EXPECT_NEAR(image.at(x, y, 2), 1.0F, 6e-8F) << x << ' ' << y;
      }
  }
}

TEST(Device, APacketOfTooManyIterationsIsTracedRayByRay) {
  if (traversals().size() == 1) GTEST_SKIP() << testDeviceInfo().name << " traces no packets";
  // One packet covers all of a fine sphere: more than 65,535 iterations.
  Scene scene;
  scene.meshes = {bumpySphere(250, 500, 0.05, glm::dvec3(0.0, 0.0, 250.0))};
  scene.camera.width = scene.camera.height = 8;
  scene.camera.fov = 0.5;
  scene.lights = {{glm::dvec3(0.0), glm::dvec3(1e6)}};
  Stats stats;
  for (const IntegratorRow* shown : {&integrators::directWhitted, &integrators::depth}) {
    scene.integrator = {shown};
    stats = {};
    const Image image = Renderer(onTestDevice("packet64")).render(scene, {}, stats).image;
    const bool endedEarly = stats.traversal == "lane";
    EXPECT_EQ(loopsEndEarly().value_or(endedEarly), endedEarly)
        << testDeviceInfo().driver << " traced by " << stats.traversal;
    // Other drivers trace the packet as a packet.
    EXPECT_EQ(stats.traversal, endedEarly ? "lane" : "packet64");
    EXPECT_EQ(differingFloats(image, render(scene, onTestDevice("lane"))), 0U);
    if (shown == &integrators::depth) {
      EXPECT_NEAR(image.at(4, 4, 0), 1.0F / 249.0F, 1e-5F);
    }
  }
  // The renderer's own choice is `lane` from the start.
  Stats own;
  Renderer(onTestDevice()).render(scene, {}, own);
  EXPECT_EQ(own.traversal, "lane");
  EXPECT_EQ(own.reasons.size() + (stats.traversal == "lane" ? 1 : 0), stats.reasons.size());
}

TEST(Device, NoHoleInAClosedMeshSeenFromInside) {
  // One sample per pixel, box filter: a ray that escapes leaves a black pixel.
  Scene scene;
  scene.integrator = {&integrators::depth};
  scene.meshes = {bumpySphere(60, 90, 0.05, glm::dvec3(0.0))};
  scene.camera.width = 1024;
  scene.camera.height = 768;
  scene.camera.fov = 120.0;
  scene.filter = {&filters::box, 0.5, 0.0, 0.0, 0.0};
  const Image image = render(scene);
  EXPECT_EQ(
      std::count_if(image.pixels.begin(), image.pixels.end(), [](float v) { return !(v > 0.5F); }),
      0);
}

}  // namespace
}  // namespace laver::test
