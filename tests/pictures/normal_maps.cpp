// Normal maps, and textures that stand for the radiance of meshes, on the device against the
// reference.
#include <random>

#include "lab/explain/explain.h"
#include "pictures/explain.h"
#include "pictures/harness.h"
#include "reference/reference.h"
#include "scene/texture_forms.h"
#include "support/bumpy_sphere.h"
#include "unit/reference_scenes.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// A map of normals up to 40 degrees from the surface's.
std::shared_ptr<const Picture> bumps() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> tilt(-0.5F, 0.5F);
  Image image = rgbImage(6, 6);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const float x = tilt(random), y = tilt(random);
    image.pixels[i] = 0.5F + 0.5F * x;
    image.pixels[i + 1] = 0.5F + 0.5F * y;
    image.pixels[i + 2] = 0.5F + 0.5F * std::sqrt(1.0F - x * x - y * y);
  }
  return std::make_shared<const Picture>(std::move(image));
}

Texture bumpMap() {
  Texture texture;
  texture.row = &textures::bitmap;
  texture.colors.fill(dvec3(1.0));
  texture.image = bumps();
  texture.raw = true;
  return texture;
}

Texture flat(const dvec3& color) {
  Texture texture;
  texture.row = &textures::constant;
  texture.colors.fill(color);
  return texture;
}

/// A lit square with texture coordinates that turn and mirror.
Scene sheet() {
  Scene scene = litSquare();
  scene.meshes[0].uvs = {{0, 0}, {0.3, 1}, {-0.7, 1.2}, {-1, 0.2}};
  scene.camera = downCamera({0.3, 0.2, 4}, 60, 64);
  scene.sampler.sampleCount = 2;
  scene.meshes.resize(1);
  return scene;
}

/// The normal is as exact as the texture's colours (tests/pictures/textures.cpp), and is divided by
/// cosines of at least 0.7.
constexpr double kTolerance = 1e-4;

TEST(NormalMaps, BendTheNormalByTheTextureCoordinates) {
  Scene scene = sheet();
  const Image plain = render(scene);
  scene.meshes[0].bsdf.show(kNormalMap, bumpMap());
  expectTraversalsMatch(scene, kTolerance);
  EXPECT_GT(differingFloats(plain, render(scene)), plain.pixels.size() / 2);
}

TEST(NormalMaps, OfOneColourTiltLikeTheirVector) {
  // dp/du of the square is +x: the colour's x tilts towards it, its y towards +y.
  Scene scene = litSquare();
  scene.meshes.resize(1);
  scene.meshes[0].uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.camera = downCamera({0, 0, 4}, 10, 8);
  const dvec3 normal = glm::normalize(dvec3(0.3, -0.2, 0.8));
  scene.meshes[0].bsdf.show(kNormalMap, flat(0.5 * normal + 0.5));
  Scene turned = scene;
  turned.meshes[0].bsdf.textures.clear();
  turned.meshes[0].normals.assign(4, normal);
  const Image image = render(scene), wanted = render(turned);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    EXPECT_NEAR(image.pixels[i], wanted.pixels[i], 1e-6F * wanted.pixels[i]);
}

TEST(NormalMaps, OnSpheresAndWithoutCoordinates) {
  Scene scene = sheet();
  Mesh ball;
  ball.sphere = Sphere{{-0.3, 0.2, 0.8}, 0.5};
  Mesh bumpy = bumpySphere(9, 14, 0.1, {0.6, 0, 0.5});
  for (dvec3& p : bumpy.positions) p = dvec3(0.6, 0, 0.5) + 0.4 * (p - dvec3(0.6, 0, 0.5));
  for (const dvec3& p : bumpy.positions)
    bumpy.normals.push_back(glm::normalize(p - dvec3(0.6, 0, 0.5)));
  scene.meshes.push_back(ball);
  scene.meshes.push_back(bumpy);
  for (Mesh& mesh : scene.meshes) mesh.bsdf.show(kNormalMap, bumpMap());
  expectTraversalsMatch(scene, kTolerance);
}

TEST(NormalMaps, WithoutADirectionOfUTakeNorisFrame) {
  Scene scene = sheet();
  for (auto& uv : scene.meshes[0].uvs) uv = {0.25, 0.5};
  scene.meshes[0].bsdf.show(kNormalMap, flat({0.7, 0.6, 0.9}));
  expectTraversalsMatch(scene, kTolerance);
}

TEST(NormalMaps, ThatAreFlatChangeNothing) {
  Scene scene = sheet();
  const Image plain = render(scene);
  scene.meshes[0].bsdf.show(kNormalMap, flat({0.5, 0.5, 1.0}));
  EXPECT_EQ(differingFloats(plain, render(scene)), 0U);
}

TEST(NormalMaps, KernelsSpecialisedOrNotGiveTheSameBits) {
  VulkanOptions generic = onTestDevice();
  generic.general = generalParts();
  Scene scene = sheet();
  EXPECT_EQ(differingFloats(render(scene), render(scene, generic)), 0U);
  scene.meshes[0].bsdf.show(kNormalMap, bumpMap());
  EXPECT_EQ(differingFloats(render(scene), render(scene, generic)), 0U);
}

TEST(Anisotropy, FollowsTheTextureCoordinatesOfEachMesh) {
  Scene scene = sheet();
  Mesh ball, plain = square(0.4, 0.3);
  ball.sphere = Sphere{{-0.3, 0.2, 0.8}, 0.5};
  scene.meshes.push_back(ball);
  scene.meshes.push_back(plain);
  for (Mesh& mesh : scene.meshes) {
    mesh.bsdf = {.row = rowCalled(bsdfRows(), "disney")};
    mesh.bsdf.set("metallic", 1.0);
    mesh.bsdf.set("roughness", 0.7);
  }
  const Image isotropic = render(scene);
  for (std::size_t i = 0; i < 2; ++i) scene.meshes[i].bsdf.set("anisotropic", 0.9);
  expectTraversalsMatch(scene, kTolerance);
  EXPECT_GT(differingFloats(isotropic, render(scene)), isotropic.pixels.size() / 4);
  scene.meshes[0].bsdf.show(kNormalMap, bumpMap());
  expectTraversalsMatch(scene, kTolerance);
}

/// A square below a lamp, a glowing sphere and a smooth glowing mesh, which show textures.
Scene glowing(const char* integrator) {
  Scene scene = sheet();
  scene.lights.clear();
  scene.integrator = {rowCalled(integratorRows(), integrator)};
  Mesh lamp = square(0.5, 0.4);
  for (dvec3& p : lamp.positions) p = {p.x - 0.4, p.y, 1.2};
  lamp.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Mesh ball;
  ball.sphere = Sphere{{0.6, 0.2, 0.7}, 0.3};
  for (Mesh* mesh : {&lamp, &ball}) {
    auto texture = std::make_shared<Texture>(bumpMap());
    if (mesh == &ball) texture->row = &textures::checker;
    texture->colors = {dvec3(1.0, 0.5, 0.2), dvec3(0.0, 0.3, 0.6)};
    texture->scale = {3.0, 5.0};
    mesh->light = AreaLight{2.0 * texture->row->mean(*texture), 2.0, texture};
    scene.meshes.push_back(*mesh);
  }
  std::swap(scene.meshes[1].positions[1], scene.meshes[1].positions[3]);  // it faces down
  std::swap(scene.meshes[1].uvs[1], scene.meshes[1].uvs[3]);
  scene.camera.width = scene.camera.height = 40;
  return scene;
}

TEST(TexturedLights, ShowAndSendWhatTheTwinDoes) {
  for (const char* integrator : {"direct_ems", "direct_mats", "path_mis"}) {
    SCOPED_TRACE(integrator);
    const Scene scene = glowing(integrator);
    const Image image = render(scene), wanted = Reference(scene).render().image;
    EXPECT_LE(shareBeyond(image, wanted), 0.03);
    EXPECT_GT(meanOf(image), 0.01);
  }
}

TEST(TexturedLights, HaveOneExpectationByEverySampling) {
  // Means of 40 x 40 pixels with 64 samples: the spread of a sample is near its mean, and emitters
  // cover little, so that a hundredth is five standard errors.
  Scene scene = glowing("direct_ems");
  scene.sampler.sampleCount = 64;
  const double byLights = meanOf(render(scene));
  scene.integrator = {rowCalled(integratorRows(), "direct_mats")};
  const double byBsdf = meanOf(render(scene));
  EXPECT_NEAR(byBsdf, byLights, 0.01 * byLights);
}

TEST(TexturedLights, OfOneColourAreItsLight) {
  Scene scene = glowing("path_mis");
  Scene plain = scene;
  for (std::size_t i = 1; i < 3; ++i) {
    scene.meshes[i].light =
        AreaLight{{0.5, 0.25, 0.125}, 0.5, std::make_shared<Texture>(flat({1.0, 0.5, 0.25}))};
    plain.meshes[i].light = AreaLight{{0.5, 0.25, 0.125}};
  }
  EXPECT_EQ(differingFloats(render(scene), render(plain)), 0U);
}

}  // namespace
}  // namespace laver::test
