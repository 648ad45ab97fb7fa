// The bits of a picture do not depend on threads, tiling, traversal or kernel.
#include <cstdlib>
#include <utility>

#include "pictures/harness.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

Scene bunny() { return smallScene("bunny-whitted.xml", 120, 5); }

TEST(SameBits, TwoRuns) { EXPECT_EQ(differingFloats(render(bunny()), render(bunny())), 0U); }

TEST(SameBits, OneAndTwoThreadsOfTheDriver) {
  ::setenv("LP_NUM_THREADS", "1", 1);
  const Image one = render(bunny());
  ::setenv("LP_NUM_THREADS", "2", 1);
  const Image two = render(bunny());
  ::unsetenv("LP_NUM_THREADS");
  EXPECT_EQ(differingFloats(one, two), 0U);
}

TEST(SameBits, OneAndTwoThreadsOfTheHost) {
  RenderOptions one, two;
  one.threads = 1;
  two.threads = 2;
  EXPECT_EQ(
      differingFloats(render(bunny(), onTestDevice(), one), render(bunny(), onTestDevice(), two)),
      0U);
}

TEST(SameBits, OtherBandsAndPasses) {
  const Scene scene = bunny();
  const Image whole = render(scene);
  // Passes of all samples of a few rows, of one row, and of two of the five samples of the whole
  // film.
  const auto width = static_cast<std::uint64_t>(scene.camera.width);
  for (const std::uint64_t slots : {width * 7 * 5, width * 5, width * width * 2}) {
    VulkanOptions vulkan = onTestDevice();
    vulkan.samplesInFlight = slots;
    Stats stats;
    const Image cut = Renderer(vulkan).render(scene, {}, stats).image;
    EXPECT_GT(stats.passes, 1U);
    EXPECT_EQ(differingFloats(whole, cut), 0U) << slots;
  }
}

TEST(SameBits, ACropIsCutOutOfTheFullPicture) {
  const Scene scene = bunny();
  const Image whole = render(scene);
  for (const Crop crop :
       {Crop{0, 0, 17, 9}, Crop{31, 30, 70, 66}, Crop{100, 1, 120, 120}, Crop{60, 60, 61, 61}}) {
    RenderOptions options;
    options.crop = crop;
    const Image part = render(scene, onTestDevice(), options);
    Image wanted = rgbImage(crop.x1 - crop.x0, crop.y1 - crop.y0);
    for (int y = crop.y0; y < crop.y1; ++y)
      for (int x = crop.x0; x < crop.x1; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          wanted.at(x - crop.x0, y - crop.y0, c) = whole.at(x, y, c);
    EXPECT_EQ(differingFloats(part, wanted), 0U);
  }
}

TEST(SameBits, KernelsSpecialisedToTheSceneOrNot) {
  VulkanOptions generic = onTestDevice();
  generic.general = generalParts();
  for (const char* name :
       {"bunny-normals.xml", "bunny-whitted.xml", "bunny-depth.xml", "cornell-two-lights.xml",
        "curved-normals.xml", "mirrored-instances.xml", "textured.xml"}) {
    const Scene scene = smallScene(name, 96, 2);
    EXPECT_EQ(differingFloats(render(scene), render(scene, generic)), 0U) << name;
  }
}

TEST(SameBits, LaneAndPackets) {
  for (const std::string& name : sceneNames()) {
    // An odd width leaves inactive rays in packets.
    const Scene scene = smallScene(name, 131, 2);
    expectSameByAll(render(scene), scene);
  }
}

TEST(SameBits, WholeFilmOrItsVisibleRegion) {
  VulkanOptions whole = onTestDevice();
  whole.wholeFilm = true;
  std::size_t less = 0;
  for (const std::string& name : sceneNames()) {
    const Scene scene = smallScene(name, 131, 3);
    RenderOptions options;
    options.layers = {&layers::normals, &layers::depth, &layers::id};
    VulkanOptions vulkan = onTestDevice();
    vulkan.poisoned = true;
    Stats stats;
    const Image image = Renderer(vulkan).render(scene, options, stats).image;
    less += stats.coverage < 0.9 ? 1 : 0;
    EXPECT_EQ(differingFloats(image, render(scene, whole, options)), 0U) << scene.file;
  }
  EXPECT_GT(less, 4U);
}

TEST(SameBits, WholeFilmOrASmallVisibleRegionInBandsAndCrops) {
  VulkanOptions whole = onTestDevice();
  whole.wholeFilm = true;
  Scene scene = smallScene("bunny-whitted.xml", 150, 20);
  scene.meshes.resize(1);  // without the floor
  scene.camera.fov = 60.0;
  // A reach of 5 pixels uses gather_lane.glsl.
  for (const auto& [kind, radius] : {std::pair(&filters::gaussian, 5.0),
                                     {&filters::mitchell, 2.0},
                                     {&filters::tent, 1.0},
                                     {&filters::box, 0.5}}) {
    scene.filter.row = kind;
    scene.filter.radius = radius;
    const Image image = render(scene, whole);
    for (const std::string& traversal : traversals()) {
      VulkanOptions vulkan = onTestDevice(traversal);
      vulkan.poisoned = true;
      EXPECT_EQ(differingFloats(image, render(scene, vulkan)), 0U) << traversal;
    }
    VulkanOptions bands = onTestDevice();
    bands.poisoned = true;
    bands.samplesInFlight = std::uint64_t{150} * 20 * 8;
    EXPECT_EQ(differingFloats(image, render(scene, bands)), 0U);
    RenderOptions crop;
    crop.crop = Crop{61, 50, 150, 83};
    EXPECT_EQ(differingFloats(render(scene, whole, crop), render(scene, bands, crop)), 0U);
    RenderOptions adaptive;
    adaptive.error = 0.02;
    adaptive.layers = {&layers::samples};
    const Image counted = render(scene, whole, adaptive);
    VulkanOptions once = onTestDevice();
    once.poisoned = true;
    for (const VulkanOptions& vulkan : {once, bands})
      EXPECT_EQ(differingFloats(counted, render(scene, vulkan, adaptive)), 0U);
  }
}

TEST(SameBits, AnyNumberOfSamplesSideBySide) {
  // 85 samples of a mesh finer than the film: tiles of 64, 16, 4 and 1 samples per pixel.
  const Scene scene = smallScene("bunny-whitted.xml", 35, 85);
  const Image image = render(scene);
  expectSameByAll(image, scene);
  for (const std::string& traversal : traversals()) {
    VulkanOptions few = onTestDevice(traversal);
    few.samplesInFlight = std::uint64_t{64} * 35 * 8;  // eight samples per pass: tiles of 4
    EXPECT_EQ(differingFloats(image, render(scene, few)), 0U) << traversal;
  }
}

TEST(SameBits, LaneAndPacketsFromInsideAMeshWithAWideView) {
  // The rays of one packet form several groups by axis, sign and slope, and so do its shadow rays,
  // since the light is inside, too.
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes = {bumpySphere(60, 90, 0.05, glm::dvec3(0.1, 0.0, 0.0))};
  for (auto& t : scene.meshes[0].triangles) std::swap(t.x, t.y);  // seen from inside
  scene.camera.width = scene.camera.height = 64;
  scene.camera.fov = 170.0;
  scene.lights = {{glm::dvec3(0.02, 0.01, 0.4), glm::dvec3(1.0)},
                  {glm::dvec3(-0.5, 0.3, 0.2), glm::dvec3(2.0)}};
  const Image image = render(scene);
  EXPECT_GT(image.at(32, 32, 0), 0.01F);
  expectSameByAll(image, scene);
}

TEST(SameBits, OrderOfTheLightsBatches) {
  // Nine lights take two dispatches; the ninth contributes exactly its own share.
  Scene scene = smallScene("cornell-two-lights.xml", 48, 1);
  scene.lights.resize(9, scene.lights.at(0));
  for (auto& light : scene.lights) light.radiance = glm::dvec3(0.0);
  scene.lights[8] = smallScene("cornell-two-lights.xml", 48, 1).lights.at(1);
  const Image nine = render(scene);
  scene.lights = {scene.lights[8]};
  EXPECT_EQ(differingFloats(nine, render(scene)), 0U);
}

}  // namespace
}  // namespace laver::test
