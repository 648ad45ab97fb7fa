// Spheres on the device against the reference, by all traversals.
#include "core/error.h"
#include "lab/chart/errors.h"
#include "lab/chart/methods/methods.h"
#include "lab/explain/explain.h"
#include "pictures/explain.h"
#include "pictures/harness.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

Mesh sphere(glm::dvec3 centre, double radius, double albedo) {
  Mesh mesh;
  mesh.sphere = Sphere{centre, radius};
  mesh.bsdf.set("albedo", glm::dvec3(albedo, 0.5, 1.0 - albedo));
  return mesh;
}

/// Spheres of all sizes inside half a bumpy sphere of triangles.
Scene someSpheres(const IntegratorRow& integrator) {
  Scene scene;
  scene.integrator = {&integrator};
  for (int i = 0; i < 40; ++i) {
    const double a = 2.4 * i, z = 1.0 - 2.0 * (i + 0.5) / 40.0, r = std::sqrt(1.0 - z * z);
    scene.meshes.push_back(sphere(glm::dvec3(r * std::cos(a), r * std::sin(a), z) * 0.8,
                                  0.3 * std::pow(0.8, i), 0.02 * i));
    if (i == 20) scene.meshes.push_back(bumpySphere(24, 40, 0.05, glm::dvec3(0.2, 0.1, 0.0)));
  }
  for (glm::dvec3& p : scene.meshes[21].positions) p *= 1.4;
  for (glm::uvec3& t : scene.meshes[21].triangles) std::swap(t.x, t.y);
  scene.meshes[21].triangles.resize(scene.meshes[21].triangles.size() / 2);
  scene.camera.width = 47;
  scene.camera.height = 33;
  scene.camera.fov = 120.0;
  scene.camera.toWorld[3] = glm::dvec4(0.1, 0.05, -0.3, 1.0);
  scene.sampler.sampleCount = 2;
  if (scene.integrator.is(integrators::averageVisibility)) scene.integrator.set("length", 0.6);
  scene.lights = {{glm::dvec3(0.1, 0.2, 0.1), glm::dvec3(1.0)},
                  {glm::dvec3(-0.3, 0.1, -0.2), glm::dvec3(0.5)}};
  return scene;
}

constexpr const IntegratorRow* kAll[] = {&integrators::directWhitted, &integrators::depth,
                                         &integrators::averageVisibility,
                                         &integrators::ambientOcclusion};

void expectMatch(const Scene& scene, bool alsoGeneric = false) {
  VulkanOptions generic = onTestDevice();
  generic.general = {"stack"};
  const Image image = render(scene);
  expectSameByAll(image, scene);
  if (alsoGeneric) {
    EXPECT_EQ(differingFloats(image, render(scene, generic)), 0U);
  }
  const Reference reference(scene);
  const Image truth = reference.render().image;
  expectExplained(image, truth, scene, reference, 1e-4);
  EXPECT_GT(
      std::count_if(truth.pixels.begin(), truth.pixels.end(), [](float v) { return v > 0.01F; }),
      image.width * image.height / 20);
}

TEST(Spheres, EveryIntegratorEqualsTheReference) {
  for (const IntegratorRow* integrator : kAll) {
    SCOPED_TRACE(integrator->name);
    expectMatch(someSpheres(*integrator));
  }
}

TEST(Spheres, WithoutTrianglesAndFromInside) {
  Scene scene;
  scene.meshes = {sphere(glm::dvec3(3.0, -1.0, 2.0), 5.0, 0.3)};
  scene.camera.width = scene.camera.height = 40;
  scene.camera.fov = 100.0;
  expectMatch(scene, true);
  scene.camera.toWorld[3] = glm::dvec4(3.0, -1.0, -20.0, 1.0);
  expectMatch(scene);
}

TEST(Spheres, UnderALightAtAnyDistance) {
  for (const double distance : {3.0, 3e2, 1e5}) {
    SCOPED_TRACE(distance);
    Scene scene;
    scene.integrator = {&integrators::directWhitted};
    scene.meshes = {sphere(glm::dvec3(0.0), 1.0, 0.5), sphere(glm::dvec3(0.5, 0.6, -1.2), 0.3, 0.2),
                    sphere(glm::dvec3(0.0, -31.0, 0.0), 30.0, 0.8)};
    scene.camera.width = scene.camera.height = 64;
    scene.camera.toWorld[3] = glm::dvec4(0.0, 0.3, -5.0, 1.0);
    PointLight light;
    light.position = glm::normalize(glm::dvec3(0.6, 0.7, -0.8)) * distance;
    light.radiance = glm::dvec3(3.0 * distance * distance);
    scene.lights = {light};
    expectMatch(scene);
  }
}

Texture picture() {
  Texture texture;
  texture.row = &textures::bitmap;
  Bitmap bitmap(12, 8, {});
  std::uint32_t random = 1;
  for (Rgb8& pixel : bitmap.pixels)
    for (auto& value : pixel)
      value = static_cast<std::uint8_t>((random = random * 1664525 + 1013904223) >> 24);
  texture.image = std::make_shared<const Picture>(std::move(bitmap));
  return texture;
}

TEST(Spheres, TexturedTheyEqualTheReferenceAtTheSeamAndThePoles) {
  Scene scene = someSpheres(integrators::directWhitted);
  // A sphere around the camera shows all of the texture. It is unlit, since its normals point
  // outwards.
  scene.meshes.push_back(sphere(glm::dvec3(0.0), 1.5, 0.0));
  scene.meshes.back().bsdf.show("albedo", picture());
  for (std::size_t i = 0; i < scene.meshes.size() - 1; i += 2) {
    scene.meshes[i].bsdf.show("albedo", Texture());
    Texture& texture = *scene.meshes[i].bsdf.texture("albedo");
    if (i % 4 == 0) texture = picture();
    texture.scale = {4.0, 3.0};
    texture.offset = {0.3, -0.2};
  }
  scene.meshes[21].bsdf.show("albedo", picture());
  int view = 0;
  for (const glm::dvec3 forward : {glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1),
                                   glm::dvec3(0.6, 0.64, -0.48)}) {
    SCOPED_TRACE(++view);
    const glm::dvec3 side = glm::normalize(glm::cross(glm::dvec3(0.1, 0.9, 0.2), forward));
    const glm::dvec4 eye = scene.camera.toWorld[3];
    scene.camera.toWorld = glm::dmat4(glm::dvec4(side, 0), glm::dvec4(glm::cross(forward, side), 0),
                                      glm::dvec4(forward, 0), eye);
    scene.integrator = {&integrators::directWhitted};
    expectMatch(scene, view == 1);
    scene.integrator = {&integrators::albedo};
    expectMatch(scene);
  }
}

TEST(Spheres, ScalingByAPowerOfTwoKeepsTheBits) {
  Scene scene = someSpheres(integrators::normals);
  const Image image = render(scene);
  const double k = 0x1p12;
  for (Mesh& mesh : scene.meshes) {
    for (glm::dvec3& p : mesh.positions) p *= k;
    if (mesh.sphere) mesh.sphere = Sphere{mesh.sphere->centre * k, mesh.sphere->radius * k};
  }
  for (PointLight& light : scene.lights) {
    light.position *= k;
    light.radiance *= k * k;
  }
  for (int i = 0; i < 3; ++i) scene.camera.toWorld[3][i] *= k;
  scene.camera.nearClip *= k;
  scene.camera.farClip *= k;
  EXPECT_EQ(differingFloats(image, render(scene)), 0U);
}

TEST(Spheres, AChartCountsMismatchesOnThem) {
  // A sphere around the camera, whose smooth inside fills the film.
  Scene scene;
  scene.integrator = {&integrators::depth};
  scene.meshes = {sphere(glm::dvec3(0.2, 0.1, 0.0), 2.0, 0.0)};
  scene.camera.width = scene.camera.height = 12;
  const Reference reference(scene);
  const Image truth = reference.render().image;
  EXPECT_EQ(chart::mismatchesOf(truth, truth, scene, reference, 0).pixels, 0U);
  Image image = truth;
  image.at(6, 7, 0) *= 1.1F;
  const chart::Mismatches m = chart::mismatchesOf(image, truth, scene, reference, 0);
  EXPECT_EQ(m.pixels, 1U);
  EXPECT_EQ(m.unexplained, 1U);
}

TEST(Spheres, EverySampleIsExplained) {
  for (const IntegratorRow* integrator : kAll) {
    SCOPED_TRACE(integrator->name);
    Scene scene = someSpheres(*integrator);
    scene.meshes[3].bsdf.show("albedo", picture());
    const Explanation e = laver::explain(scene, scene, onTestDevice());
    EXPECT_EQ(e.unexplained(), 0U) << describe(e);
    // Negative control: a sphere that fills a tenth of the film, enlarged by 1e-4.
    Scene larger = scene;
    larger.meshes[0].sphere->radius *= 1.0001;
    EXPECT_GT(laver::explain(scene, larger, onTestDevice()).unexplained(), 20U);
  }
}

TEST(Spheres, AreNotTracedByChartedMethods) {
  const Scene scene = someSpheres(integrators::normals);
  try {
    chart::chartMethods(scene, testDevice(), 1, {});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::Usage);
  }
}

}  // namespace
}  // namespace laver::test
