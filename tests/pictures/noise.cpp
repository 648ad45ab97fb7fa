// The layer of variances against the spread of many renders, and tests of noise between pictures.
#include <cmath>

#include "image/io.h"
#include "image/noise_test.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"
#include "reference/reference.h"
#include "render/tiling.h"
#include "unit/reference_scenes.h"

namespace laver::test {
namespace {

/// A square below a square lamp, whose light is noisy.
Scene lamp(const char* integrator) {
  Scene scene = litSquare();
  scene.lights.clear();
  scene.integrator = {rowCalled(integratorRows(), integrator)};
  Mesh& light = scene.meshes[1] = square(0.6, 0);
  for (glm::dvec3& p : light.positions) p = {p.x - 0.8, -p.y, 1.5};
  light.light = AreaLight{{4.0, 6.0, 8.0}};
  scene.camera.width = 30;
  scene.camera.height = 20;
  return scene;
}

RenderOptions withVariance() {
  RenderOptions options;
  options.layers = {&layers::variance};
  return options;
}

/// Renders of seeds 1 to n.
std::vector<Image> seeds(Scene scene, std::int64_t n, bool reference) {
  VulkanOptions vulkan = onTestDevice();
  vulkan.keepsKernels = true;
  Renderer renderer(vulkan);
  std::vector<Image> all;
  for (std::int64_t seed = 1; seed <= n; ++seed) {
    scene.sampler.seed = seed;
    Stats stats;
    all.push_back(reference ? Reference(scene).render(withVariance()).image
                            : renderer.render(scene, withVariance(), stats).image);
  }
  return all;
}

/// Means over the film: of the variance of the pictures, and of the layers.
struct Spread {
  double found = 0.0, layer = 0.0;
};

Spread spreadOf(const std::vector<Image>& all) {
  const auto n = static_cast<double>(all.size());
  const std::size_t channels = all.front().channels.size();
  Spread spread;
  for (std::size_t i = 0; i < all.front().pixels.size(); i += channels) {
    double sum = 0.0, squares = 0.0;
    for (const Image& image : all) {
      const auto value = static_cast<double>(image.pixels[i]);
      sum += value;
      squares += value * value;
      spread.layer += static_cast<double>(image.pixels[i + 3]) / n;
    }
    spread.found += (squares - sum * sum / n) / (n - 1.0);
  }
  return spread;
}

class Variances : public testing::TestWithParam<const char*> {};

TEST_P(Variances, AreThoseOfManySeeds) {
  // The variance of 150 values has a standard deviation of 0.12 of itself, and up to twice that
  // where noise is not normal. The 600 pixels show the samples of 25 each, so that their mean has
  // 0.04, and the bound is three of them.
  Scene scene = lamp("direct_mats");
  scene.sampler.sampleCount = 6;
  scene.filter = filterOf(*rowCalled(filterRows(), GetParam()));
  const Spread spread = spreadOf(seeds(scene, 150, false));
  EXPECT_GT(spread.found, 0.0);
  EXPECT_NEAR(spread.layer / spread.found, 1.0, 0.12);
}

TEST(Variance, OfTheReferenceIsThatOfManySeeds) {
  Scene scene = lamp("direct_mats");
  scene.sampler.sampleCount = 6;
  const Spread spread = spreadOf(seeds(scene, 150, true));
  EXPECT_GT(spread.found, 0.0);
  EXPECT_NEAR(spread.layer / spread.found, 1.0, 0.12);
}

INSTANTIATE_TEST_SUITE_P(Filters, Variances,
                         testing::Values("box", "gaussian", "mitchell", "tent"));

TEST(Variance, OfPassesAndBandsIsThatOfOne) {
  Scene scene = lamp("direct_ems");
  scene.sampler.sampleCount = 24;
  VulkanOptions small = onTestDevice();
  small.samplesInFlight = 30 * 12 * 8;
  const Image whole = render(scene, onTestDevice(), withVariance());
  const Image parts = render(scene, small, withVariance());
  const Spread one = spreadOf({whole, whole}), other = spreadOf({parts, parts});
  // Groups of 8 samples estimate the same variance as groups of 24, from other differences: over
  // the film, the two estimates are a few percent apart.
  EXPECT_NEAR(other.layer / one.layer, 1.0, 0.05);
}

TEST(Variance, WithoutNoiseIsRoundingOnly) {
  Scene scene = lamp("direct_ems");
  scene.meshes.erase(scene.meshes.begin());
  scene.camera.fov = 5;  // the lamp's back alone, or nothing
  scene.environment = Environment{};
  scene.environment->radiance = {1.0, 2.0, 3.0};
  const Image image = render(scene, onTestDevice(), withVariance());
  for (std::size_t i = 0; i < image.pixels.size(); i += 6) EXPECT_LE(image.pixels[i + 3], 1e-12F);
}

TEST(Variance, EqualScenesAgreeAndDarkerOnesDoNot) {
  // 384 of the 120 x 80 pixels share no samples. Of 64 samples per pixel the difference of their
  // means has a standard error of 0.25 % (17 of 20 renders told 1 % apart), of 256 half of that.
  Scene scene = lamp("direct_ems");
  scene.camera.width = 120;
  scene.camera.height = 80;
  scene.sampler.sampleCount = 256;
  const std::vector<Image> all = seeds(scene, 10, false);
  scene.meshes[1].light->radiance *= 0.99;
  scene.sampler.seed = 100;
  const Image darker = render(scene, onTestDevice(), withVariance());
  int failures = 0;
  for (std::size_t i = 0; i + 1 < all.size(); i += 2)
    failures += testNoise(all[i], all[i + 1], {}, 2).passed ? 0 : 1;
  EXPECT_LE(failures, 1);  // of five, at a significance of 0.01: twice once in a thousand times
  for (const Image& image : all) EXPECT_FALSE(testNoise(darker, image, {}, 2).passed);
}

TEST(Variance, OfTheDeviceAndTheReferenceAgree) {
  Scene scene = lamp("path_mis");
  scene.camera.width = 60;
  scene.camera.height = 40;
  scene.sampler.sampleCount = 32;
  const Image image = render(scene, onTestDevice(), withVariance());
  scene.sampler.seed = 9;
  const Image wanted = Reference(scene).render(withVariance()).image;
  const NoiseTest test = testNoise(image, wanted, {1e-4, 0.9975}, 2);
  EXPECT_TRUE(test.passed) << test.agree << " " << test.meanP;
}

using NoiseCommand = CommandLine;

TEST_F(NoiseCommand, ComparesFilesAndSaysWhatIsMissing) {
  write("a.xml",
        "<scene><integrator type=\"ao\"/><mesh type=\"sphere\"/><camera type=\"perspective\">"
        "<transform name=\"toWorld\"><translate value=\"0 0 -4\"/></transform></camera></scene>");
  const std::string render = "a.xml -q --size 40x30 --spp 8 --device $device ";
  ASSERT_EQ(laver(render + "--layers variance --seed 1 -o a.exr").code, 0);
  ASSERT_EQ(laver(render + "--layers variance --seed 2 -o b.exr").code, 0);
  ASSERT_EQ(laver(render + "-o c.exr").code, 0);
  const Outcome equal = laver("compare a.exr b.exr --noise --out d");
  EXPECT_EQ(equal.code, 0) << equal.out;
  EXPECT_NE(equal.out.find("noise explains the difference"), std::string::npos) << equal.out;
  EXPECT_EQ(readExr((folder_ / "d/p.exr").string()).channels, std::vector<std::string>{"p"});
  EXPECT_TRUE(fs::exists(folder_ / "d/p.png"));
  const Outcome lacking = laver("compare a.exr c.exr --noise");
  EXPECT_EQ(lacking.code, 2);
  EXPECT_NE(lacking.err.find("variance"), std::string::npos) << lacking.err;
  write("b.xml",
        "<scene><integrator type=\"normals\"/><mesh type=\"sphere\"/><camera type=\"perspective\">"
        "<transform name=\"toWorld\"><translate value=\"0 0 -4\"/></transform></camera></scene>");
  ASSERT_EQ(laver("b.xml -q --size 40x30 --spp 8 --device $device --layers variance -o e.exr").code,
            0);
  const Outcome other = laver("compare a.exr e.exr --noise --json");
  EXPECT_EQ(other.code, 5);
  EXPECT_NE(other.out.find("\"equal\": false"), std::string::npos) << other.out;
}

TEST_F(NoiseCommand, RefusesVariancesThatCannotBe) {
  write("a.xml", kFirstScene);
  for (const char* arguments : {"--spp 1", "--spp 16 --error 0.01", "--spp 4 --resume"}) {
    const Outcome run =
        laver(std::string("a.xml --layers variance --device $device -q ") + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_NE(run.err.find("--layers variance"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace laver::test
