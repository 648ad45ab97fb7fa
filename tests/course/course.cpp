// Pictures that courses hand out, in a folder that LAVER_COURSE_PICTURES names: it is not part of
// laver. LAVER_COURSE_SAMPLES, if set, is the most samples per pixel.
#include <cstdlib>
#include <iostream>

#include "course/blocks.h"
#include "image/io.h"
#include "pictures/harness.h"

namespace laver::test {
namespace {

struct CoursePicture {
  const char *scene, *picture, *dialect;
  std::uint32_t samples = 0;  ///< of the picture; 0: the scene's
};

void PrintTo(const CoursePicture& picture, std::ostream* out) { *out << picture.scene; }

std::string nameOf(const CoursePicture& picture) {
  return std::filesystem::path(picture.scene).filename().string();
}

class Course : public testing::TestWithParam<CoursePicture> {};

Image renderSeed(const CoursePicture& picture, const std::string& file, std::int64_t seed) {
  SceneOverrides overrides;
  overrides.dialect = rowCalled(dialects(), picture.dialect);
  overrides.seed = seed;
  Scene scene = loadScene(file, overrides).scene;
  if (picture.samples != 0) scene.sampler.sampleCount = picture.samples;
  if (const char* most = std::getenv("LAVER_COURSE_SAMPLES"))
    scene.sampler.sampleCount =
        std::min(scene.sampler.sampleCount, static_cast<std::uint32_t>(std::stoul(most)));
  return render(scene);
}

TEST_P(Course, PictureAgrees) {
  const char* folder = std::getenv("LAVER_COURSE_PICTURES");
  if (folder == nullptr) GTEST_SKIP() << "LAVER_COURSE_PICTURES names no folder of pictures";
  const CoursePicture picture = GetParam();
  const auto file = [&](const std::string& name) {
    return (std::filesystem::path(folder) / name).string();
  };
  const std::string scene = file(picture.scene) + std::string(".xml");
  const Agreement agreement = agreementOf(
      renderSeed(picture, scene, 1), renderSeed(picture, scene, 2), readExr(file(picture.picture)));
  std::cout << agreement.row(nameOf(picture)) << '\n';
  EXPECT_TRUE(agreement.holds());
}

// The camera of Nori 1 (dialect nori1) made the pictures of two scenes that a later course uses.
INSTANTIATE_TEST_SUITE_P(
    Full, Course,
    testing::Values(
        CoursePicture{"eth/pa1/mesh-texture", "eth/pa1/ref/mesh-texture.exr", "eth"},
        CoursePicture{"eth/pa3/sphere/sphere_ems", "eth/pa3/sphere/ref/sphere_ems.exr", "eth"},
        CoursePicture{"eth/pa3/sphere/sphere2_mats", "eth/pa3/sphere/ref/sphere2_mats.exr", "eth"},
        CoursePicture{"eth/pa3/odyssey/odyssey_mis", "eth/pa3/odyssey/ref/odyssey_mis_32spp.exr",
                      "nori1", 32},
        CoursePicture{"eth/pa3/veach_mi/veach_mis", "eth/pa3/veach_mi/ref/veach_mis_128spp.exr",
                      "nori1", 128},
        CoursePicture{"eth/pa4/table/table_path_mis", "eth/pa4/table/ref/table_path_mis_512spp.exr",
                      "eth", 512},
        CoursePicture{"zaragoza/assignment-2/cbox/cbox_ems",
                      "zaragoza/assignment-2/references/cbox_ems.exr", "zaragoza"},
        CoursePicture{"zaragoza/assignment-3/cbox/cbox_substrate_ems",
                      "zaragoza/assignment-3/references/cbox_substrate_ems.exr", "zaragoza"}),
    [](const auto& row) {
      std::string name = nameOf(row.param);
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

/// A picture of noise around a ramp from left to right.
Image noisyRamp(std::uint32_t seed, double offset) {
  Image image = rgbImage(64, 64);
  std::uint32_t state = seed;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    state = state * 1664525U + 1013904223U;
    const double noise = static_cast<double>(state >> 8) / 16777216.0 - 0.5;
    const double x = static_cast<double>(i / 3 % 64);
    image.pixels[i] = static_cast<float>((x + offset) / 64.0 + 0.2 * noise);
  }
  return image;
}

TEST(CourseAgreement, HoldsForNoiseAndNotForAShiftOrAFactor) {
  const Image a = noisyRamp(1, 0.0), b = noisyRamp(2, 0.0), c = noisyRamp(3, 0.0);
  EXPECT_TRUE(agreementOf(a, b, c).holds());
  Image brighter = c;
  for (float& value : brighter.pixels) value *= 1.01F;
  EXPECT_FALSE(agreementOf(a, b, brighter).holds());
  EXPECT_FALSE(agreementOf(a, b, noisyRamp(3, 2.0)).holds());
  EXPECT_THROW(agreementOf(a, b, rgbImage(32, 64)), std::invalid_argument);
}

}  // namespace
}  // namespace laver::test
