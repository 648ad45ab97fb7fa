// Textures and backgrounds on the device against the reference, by all traversals.
#include <limits>
#include <random>

#include "lab/explain/explain.h"
#include "pictures/explain.h"
#include "pictures/harness.h"
#include "render/choices.h"
#include "support/bumpy_sphere.h"
#include "unit/reference_scenes.h"

namespace laver::test {
namespace {

using glm::dvec2;
using glm::dvec3;

std::shared_ptr<const Picture> noise(int width, int height, bool floats, float largest = 1.0F) {
  std::mt19937 random(7);
  if (!floats) {
    Bitmap bitmap(width, height, {});
    for (Rgb8& pixel : bitmap.pixels)
      for (auto& value : pixel) value = static_cast<std::uint8_t>(random());
    return std::make_shared<const Picture>(std::move(bitmap));
  }
  Image image = rgbImage(width, height);
  std::uniform_real_distribution<float> value(0.0F, largest);
  for (float& v : image.pixels) v = value(random);
  return std::make_shared<const Picture>(std::move(image));
}

Texture showing(std::shared_ptr<const Picture> picture) {
  Texture texture;
  texture.row = &textures::bitmap;
  texture.colors.fill(dvec3(0.9, 0.8, 0.7));
  texture.image = std::move(picture);
  return texture;
}

/// A lit square with texture coordinates, and a small one without a texture in front of it.
Scene sheet(const Texture& texture) {
  Scene scene = litSquare();
  scene.meshes[0].uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.meshes[0].bsdf.show("albedo", texture);
  scene.meshes[1] = square(0.25, 0.5);
  scene.camera = downCamera({0.3, 0.2, 4}, 60, 96);
  scene.sampler.sampleCount = 2;
  return scene;
}

void expectMatch(const Scene& scene, double tolerance) {
  expectTraversalsMatch(scene, tolerance);
  const Image image = render(scene);
  EXPECT_GT(*std::max_element(image.pixels.begin(), image.pixels.end()), 0.01F);
}

// Texture coordinates are off by about 2^-21 of the image's repetition (explain/bounds.cpp). Times
// 8 pixels, two repetitions, a range of 1 and a radiance / pi of up to 4: 1e-5.
constexpr double kTolerance = 5e-5;

struct PictureCase {
  int width, height;
  bool floats, raw;
};

TEST(Textures, ImagesOfBytesAndFloatsThatWrapAround) {
  for (const PictureCase& c : {PictureCase{8, 5, false, false},
                               {8, 5, true, false},
                               {1, 4, false, true},
                               {1, 1, true, false}}) {
    SCOPED_TRACE(testing::Message() << c.width << "x" << c.height << " floats " << c.floats);
    Texture texture = showing(noise(c.width, c.height, c.floats));
    texture.raw = c.raw;
    texture.scale = {-2.0, 1.5};
    texture.offset = {0.25, -7.125};
    expectMatch(sheet(texture), kTolerance);
  }
}

TEST(Textures, ACheckerWhoseEdgesAreDecisions) {
  Texture texture;
  texture.scale = {7, 5};
  texture.offset = {-3.3, 0.1};
  expectMatch(sheet(texture), kTolerance);
}

TEST(Textures, EachRowEqualsItsTwin) {
  for (const TextureRow* row : textureRows()) {
    SCOPED_TRACE(row->name);
    Texture texture;
    texture.row = row;
    texture.colors = {dvec3(0.9, 0.2, 0.1), dvec3(0.1, 0.5, 0.9)};
    texture.scale = {3.3, 2.7};
    texture.offset = {0.3, 0.1};
    if (row->picture) texture.image = noise(8, 5, false);
    expectMatch(sheet(texture), kTolerance);
  }
}

TEST(Textures, TheRedChannelIsGrey) {
  for (const bool floats : {false, true}) {
    Texture texture = showing(noise(8, 5, floats));
    texture.red = true;
    expectMatch(sheet(texture), kTolerance);
  }
}

TEST(Textures, AllKindsInOneScene) {
  Scene scene = sheet(showing(noise(8, 8, false)));
  scene.meshes.push_back(square(0.4, 0.3));
  scene.meshes.back().bsdf.show("albedo", showing(noise(4, 4, true)));
  scene.meshes.push_back(square(0.6, 0.2));
  scene.meshes.back().bsdf.show("albedo", Texture());
  scene.environment = Environment();
  scene.environment->row = &emitters::environment;
  scene.environment->image = noise(8, 4, true);
  expectMatch(scene, kTolerance);
}

TEST(Textures, ASmoothMeshWithoutCoordinates) {
  Scene scene = sheet(showing(noise(4, 4, false)));
  scene.meshes[0] = bumpySphere(9, 14, 0.1, {0, 0, 0});
  for (const dvec3& p : scene.meshes[0].positions)
    scene.meshes[0].normals.push_back(glm::normalize(p));
  scene.meshes[0].bsdf.show("albedo", showing(noise(4, 4, false)));
  scene.meshes.resize(1);
  expectMatch(scene, kTolerance);
}

TEST(Textures, ManyLightsAddTheBackgroundOnce) {
  Scene scene = sheet(showing(noise(8, 8, false)));
  scene.environment = Environment();
  scene.environment->radiance = {0.25, 0.5, 0.75};
  const PointLight light{scene.lights[0].position, scene.lights[0].radiance / 21.0};
  scene.lights.assign(21, light);
  expectMatch(scene, kTolerance);
}

TEST(Textures, KernelsSpecialisedOrNotGiveTheSameBits) {
  VulkanOptions generic = onTestDevice();
  generic.general = generalParts();
  for (const bool floats : {false, true}) {
    Scene scene = sheet(showing(noise(8, 8, floats)));
    EXPECT_EQ(differingFloats(render(scene), render(scene, generic)), 0U);
    scene.meshes[0].bsdf.show("albedo", Texture());
    scene.environment = Environment();
    scene.environment->row = &emitters::environment;
    scene.environment->image = noise(8, 4, floats);
    EXPECT_EQ(differingFloats(render(scene), render(scene, generic)), 0U);
  }
}

TEST(Textures, CoordinatesOfAnySizeReadNothingOutsideTheImage) {
  // The words after an image belong to another one, a thousand times as bright.
  constexpr double kHuge = std::numeric_limits<double>::max();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double size : {1e9, 1e38, kHuge, kNan}) {
    Scene scene = sheet(showing(noise(3, 3, true)));
    scene.meshes[0].uvs = {{size, 0}, {1, size}, {-size, size}, {0, -size}};
    scene.meshes[1].bsdf.show("albedo", showing(noise(9, 9, true, 1000.0F)));
    for (dvec3& p : scene.meshes[1].positions) p.z = -9;  // hidden
    const Image image = render(scene);
    expectSameByAll(image, scene);
    EXPECT_LT(*std::max_element(image.pixels.begin(), image.pixels.end()), 10.0F) << size;
    EXPECT_GT(*std::max_element(image.pixels.begin(), image.pixels.end()), 0.0F) << size;
  }
}

Scene skyAlone(const dvec3& forward) {
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  const dvec3 side = glm::normalize(glm::cross(dvec3(0.3, 0.1, 1), forward));
  scene.camera.toWorld = glm::dmat4(glm::dvec4(side, 0), glm::dvec4(glm::cross(forward, side), 0),
                                    glm::dvec4(forward, 0), glm::dvec4(3, 4, 5, 1));
  scene.camera.width = scene.camera.height = 96;
  scene.camera.fov = 120;
  scene.sampler.sampleCount = 2;
  scene.environment = Environment();
  scene.environment->radiance = {1.0, 2.0, 3.0};
  return scene;
}

TEST(Backgrounds, AConstant) {
  const Image image = render(skyAlone({0, 0, 1}));
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    ASSERT_NEAR(static_cast<double>(image.pixels[i]) / (1.0 + static_cast<double>(i % 3)), 1.0,
                1e-6);  // filters
}

TEST(Backgrounds, ImagesAtTheSeamAndThePolesAndRotated) {
  int number = 0;
  for (const dvec3 forward :
       {dvec3(0, 0, -1), dvec3(0, 1, 0), dvec3(0, -1, 0), glm::normalize(dvec3(1, 2, -3))}) {
    const bool floats = ++number % 2 == 0, turned = number > 2;
    SCOPED_TRACE(testing::Message() << "case " << number);
    Scene scene = skyAlone(forward);
    scene.environment->row = &emitters::environment;
    scene.environment->image = noise(16, 8, floats);
    // Far beyond the range of a float's square; rotated, mirrored and translated.
    if (turned)
      scene.environment->toWorld =
          glm::dmat4(0, 5e20, 0, 0, 3e20, 0, 4e20, 0, -4e20, 0, 3e20, 0, 1, 2, 3, 1);
    expectMatch(scene, 1e-4);
  }
}

TEST(Backgrounds, NormalsAndDepthDoNotShowThem) {
  for (const IntegratorRow* integrator : {&integrators::normals, &integrators::depth}) {
    Scene scene = litSquare();
    scene.integrator = {integrator};
    const Image without = render(scene);
    scene.environment = Environment();
    scene.meshes[0].bsdf.show("albedo", Texture());
    EXPECT_EQ(differingFloats(without, render(scene)), 0U);
  }
}

TEST(Backgrounds, EverySampleOfTexturesAndBackgroundIsExplained) {
  Scene scene = sheet(showing(noise(64, 64, false)));
  scene.environment = Environment();
  scene.environment->row = &emitters::environment;
  scene.environment->image = noise(64, 32, true);
  const laver::Explanation whole = laver::explain(scene, scene, onTestDevice());
  EXPECT_EQ(whole.unexplained(), 0U) << describe(whole);
  // Negative control: a shift by a tenth of a pixel, and a background rotated by as much.
  Scene shifted = scene;
  shifted.meshes[0].bsdf.texture("albedo")->offset.x += 0.1 / 64;
  EXPECT_GT(laver::explain(scene, shifted, onTestDevice()).unexplained(), 100U);
  shifted = scene;
  const double a = 0.01;
  shifted.environment->toWorld = glm::dmat4(std::cos(a), 0, -std::sin(a), 0, 0, 1, 0, 0,
                                            std::sin(a), 0, std::cos(a), 0, 0, 0, 0, 1);
  EXPECT_GT(laver::explain(scene, shifted, onTestDevice()).unexplained(), 100U);
}

TEST(TextureData, ImagesArePackedOnceAndBytesStayBytes) {
  Scene scene = sheet(showing(noise(8, 8, false)));
  scene.meshes[1].bsdf.show("albedo", *scene.meshes[0].bsdf.texture("albedo"));
  const Packed data = pack(scene, {}, uploadsOf(scene, {}));
  EXPECT_EQ(data.images.size(), 256U + 64U);
  EXPECT_EQ(data.uvs.size(), 12U);
  EXPECT_EQ(data.textures.size(), 2U);
  // A texel for the albedo, one for the place of its texture.
  EXPECT_EQ(data.materials.size(), 2U * 8U);
}

TEST(TextureData, UnusedImagesAreNotUploaded) {
  Scene scene = sheet(showing(noise(8, 8, false)));
  scene.environment = Environment();
  scene.environment->row = &emitters::environment;
  scene.environment->image = noise(8, 4, true);
  using Sizes = std::pair<std::size_t, std::size_t>;  // words of images, texture coordinates
  const auto packed = [&] {
    const Packed data = pack(scene, {}, uploadsOf(scene, {}));
    return Sizes(data.images.size(), data.uvs.size());
  };
  EXPECT_EQ(packed(), Sizes(256U + 64U + 96U, 6U));
  scene.lights.clear();
  EXPECT_EQ(packed(), Sizes(96U, 0U));
  scene.integrator = {&integrators::normals};
  EXPECT_EQ(packed(), Sizes(0U, 0U));
}

}  // namespace
}  // namespace laver::test
