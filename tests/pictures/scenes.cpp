// Every scene of scenes/ on the test device against the double-precision reference.
#include <algorithm>

#include "pictures/explain.h"
#include "pictures/harness.h"

namespace laver::test {
namespace {

// The accuracy that laver promises. Float arithmetic over unit-sized data keeps values of about 1
// within some tens of ulp (6e-8), so 1e-4 has room for grazing angles but not for another surface.
constexpr double kTolerance = 1e-4;

void expectMatch(const Scene& scene, bool noriCompat = false) {
  RenderOptions options;
  options.noriCompat = noriCompat;
  const Image image = render(scene, onTestDevice(), options);
  const Reference reference(scene);
  const Image truth = reference.render(options).image;
  expectExplained(image, truth, scene, reference, kTolerance);
  // A black picture would agree with a black reference.
  EXPECT_GT(
      std::count_if(truth.pixels.begin(), truth.pixels.end(), [](float v) { return v > 0.01F; }),
      image.width * image.height / 20);
}

class EveryScene : public testing::TestWithParam<std::string> {};

TEST_P(EveryScene, EqualsTheReference) { expectMatch(smallScene(GetParam(), 160, 4)); }

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(explainedSceneNames()),
                         sceneTestName);

class FullSizeScene : public testing::TestWithParam<std::string> {};

TEST_P(FullSizeScene, EqualsTheReference) {
  expectMatch(loadScene((scenesFolder() / GetParam()).string()).scene);
}
INSTANTIATE_TEST_SUITE_P(Full, FullSizeScene, testing::ValuesIn(explainedSceneNames()),
                         sceneTestName);

// Update the number with each new scene, so that a lost one is noticed.
TEST(Scenes, AreAllFound) { EXPECT_EQ(sceneNames().size(), 16U); }

TEST(Scenes, EveryFilterEqualsTheReferenceExactAndByNorisTable) {
  Scene scene = smallScene("cornell-two-lights.xml", 96, 3);
  for (const FilterRow* kind :
       {&filters::gaussian, &filters::mitchell, &filters::tent, &filters::box}) {
    scene.filter = {};
    scene.filter.row = kind;
    if (kind == &filters::tent) scene.filter.radius = 1.0;
    if (kind == &filters::box) scene.filter.radius = 0.5;
    for (const bool compat : {false, true}) {
      SCOPED_TRACE(testing::Message() << "filter " << kind->name << " compat " << compat);
      expectMatch(scene, compat);
    }
  }
  scene.filter = {&filters::gaussian, 3.7, 1.1, 0.0, 0.0};
  expectMatch(scene);
}

TEST(Scenes, EverySamplerEqualsTheReference) {
  Scene scene = smallScene("cornell-two-lights.xml", 96, 6);
  for (const SamplerRow* kind : {&samplers::stratified, &samplers::sobol}) {
    SCOPED_TRACE(kind->name);
    scene.sampler.row = kind;
    expectMatch(scene);
  }
}

TEST(Scenes, ManyLightsAreSummedOverSeveralDispatches) {
  Scene scene = smallScene("cornell-two-lights.xml", 64, 2);
  const PointLight first = scene.lights.at(0);
  scene.lights.clear();
  for (int i = 0; i < 37; ++i) {
    PointLight light = first;
    light.position += glm::dvec3(0.01 * i, -0.005 * i, 0.007 * i);
    light.radiance /= 37.0;
    scene.lights.push_back(light);
  }
  expectMatch(scene);
}

TEST(Scenes, FourThousandSamplesPerPixelLoseNone) {
  // One invocation may run 65,535 loop iterations on lavapipe; samples beyond that would be lost.
  expectMatch(smallScene("cornell-two-lights.xml", 12, 4096));
}

TEST(Scenes, WithoutLightsThePictureIsBlack) {
  Scene scene = smallScene("cornell-two-lights.xml", 32, 1);
  scene.lights.clear();
  const Image image = render(scene);
  EXPECT_TRUE(
      std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return v == 0.0F; }));
}

TEST(Scenes, WithoutMeshesThePictureIsBlack) {
  Scene scene;
  scene.camera.width = 40;
  scene.camera.height = 30;
  const Image image = render(scene);
  EXPECT_EQ(image.width, 40);
  EXPECT_TRUE(
      std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return v == 0.0F; }));
}

TEST(Scenes, TheFirstOfCopiedTrianglesIsHitWhateverTheOrderOfCorners) {
  // Six copies of every triangle of a soup, with corners permuted. They face both ways and have
  // different albedos, so a wrong winner is visible.
  Scene scene = smallScene("cornell-two-lights.xml", 96, 2);
  Mesh all;
  for (const Mesh& mesh : scene.meshes)
    for (const glm::uvec3& t : mesh.triangles) {
      for (int c = 0; c < 3; ++c) all.positions.push_back(mesh.positions[t[c]]);
      const auto first = static_cast<unsigned>(all.positions.size() - 3);
      all.triangles.emplace_back(first, first + 1, first + 2);
    }
  scene.meshes = {all};
  scene.meshes[0].bsdf.set("albedo", glm::dvec3(0.9, 0.1, 0.1));
  for (const glm::uvec3 order : {glm::uvec3(1, 2, 0), glm::uvec3(2, 0, 1), glm::uvec3(0, 2, 1),
                                 glm::uvec3(1, 0, 2), glm::uvec3(2, 1, 0)}) {
    Mesh copy = all;
    for (auto& t : copy.triangles)
      t = {t[static_cast<int>(order.x)], t[static_cast<int>(order.y)],
           t[static_cast<int>(order.z)]};
    copy.bsdf.set("albedo", glm::dvec3(0.1, 0.9, 0.1));
    scene.meshes.push_back(copy);
  }
  const Image six = render(scene);
  scene.meshes.resize(1);
  EXPECT_EQ(differingFloats(six, render(scene)), 0U);
}

TEST(Scenes, AnUnexplainedDifferenceIsFound) {
  // Negative control: one pixel in the middle of a wall is brightened.
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 2);
  const Reference reference(scene);
  const Judge judge(scene, reference);
  const Image truth = reference.render().image;
  Image wrong = truth;
  std::uint64_t changed = 0;
  for (int y = 0; y < 64 && changed == 0; ++y)
    for (int x = 0; x < 64 && changed == 0; ++x) {
      const Image before = wrong;
      wrong.at(x, y, 1) += 0.001F;
      const PixelDifferences found = explainPixels(wrong, truth, judge, kTolerance);
      ASSERT_EQ(found.differing, 1U);
      changed = found.unexplained;
      if (changed == 0) wrong = before;
    }
  EXPECT_EQ(changed, 1U);
}

}  // namespace
}  // namespace laver::test
