// Shadow rays cause no acne, however far the light is.
#include <algorithm>
#include <numbers>

#include "lab/explain/judge.h"
#include "pictures/harness.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

/// A sphere under a distant light that is equally bright on it at any distance; one sample per
/// pixel.
Scene litSphere(double bump, double distance) {
  const glm::dvec3 centre(0.3, 0.2, 0.1);
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes = {bumpySphere(150, 300, bump, centre)};
  scene.camera.width = scene.camera.height = 300;
  scene.camera.toWorld[3] = glm::dvec4(0.3, 0.2, -5.0, 1.0);
  scene.filter = {&filters::box, 0.5, 0.0, 0.0, 0.0};
  PointLight light;
  light.position = centre + glm::normalize(glm::dvec3(1.0, 0.7, -0.6)) * distance;
  light.radiance = glm::dvec3(std::numbers::pi * distance * distance);
  scene.lights = {light};
  return scene;
}

class Shadows : public testing::TestWithParam<double> {};

TEST_P(Shadows, NoFacetShadowsItselfOrItsNeighbour) {
  for (const double bump : {0.0, 0.05}) {
    const Scene scene = litSphere(bump, GetParam());
    const Image image = render(scene);
    const Reference reference(scene);
    const Image truth = reference.render().image;
    const auto lit =
        std::count_if(truth.pixels.begin(), truth.pixels.end(), [](float v) { return v > 0.05F; });
    EXPECT_GT(lit, 20000);
    const PixelDifferences found = explainPixels(image, truth, Judge(scene, reference), 1e-3);
    EXPECT_EQ(found.unexplained, 0U) << "bump " << bump << ": " << found.first;
    EXPECT_LT(found.differing, 20U);
  }
}
INSTANTIATE_TEST_SUITE_P(LightDistance, Shadows, testing::Values(3.0, 30.0, 3e3, 3e4, 1e6));

/// A tilted disc as a fan of triangles, larger than the film.
Scene disc(const IntegratorRow& integrator, std::uint32_t corners) {
  const glm::dvec3 centre(0.2, 0.1, -0.3), normal = glm::normalize(glm::dvec3(0.3, 0.8, 0.52));
  const glm::dvec3 u = glm::normalize(glm::cross(normal, glm::dvec3(1.0, 0.0, 0.0)));
  const glm::dvec3 v = glm::cross(normal, u);
  Mesh mesh;
  mesh.positions.push_back(centre);
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    mesh.positions.push_back(centre + std::cos(angle) * u + std::sin(angle) * v);
    mesh.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % corners);
  }
  mesh.bsdf.set("albedo", glm::dvec3(0.5));
  Scene scene;
  scene.meshes = {mesh};
  scene.integrator = {&integrator};
  scene.camera.width = scene.camera.height = 64;
  scene.camera.fov = 20.0;
  scene.camera.toWorld =
      glm::dmat4(glm::dvec4(u, 0.0), glm::dvec4(v, 0.0), glm::dvec4(-normal, 0.0),
                 glm::dvec4(centre + 4.0 * normal, 1.0));
  scene.sampler.sampleCount = 16;
  return scene;
}

/// A disc is nowhere in its own way, so that no pixel differs by more than rounding: 2^-20 of 1.
TEST(NarrowTriangles, DoNotShadowThemselvesOrTheirNeighbours) {
  for (const std::uint32_t corners : {100U, 5000U})
    for (const std::string& traversal : traversals()) {
      const Image open =
          render(disc(integrators::ambientOcclusion, corners), onTestDevice(traversal));
      for (const float value : open.pixels)
        ASSERT_NEAR(value, 1.0F, 1e-6F) << traversal << ", " << corners << " corners";
    }
}

TEST(NarrowTriangles, AreLitByAPointLightAsAWhole) {
  for (const std::uint32_t corners : {100U, 1000U})
    for (const std::string& traversal : traversals()) {
      Scene scene = disc(integrators::directWhitted, corners);
      PointLight light;
      light.position = glm::dvec3(1.0, 4.0, 2.0);
      light.radiance = glm::dvec3(100.0);
      scene.lights = {light};
      const Image image = render(scene, onTestDevice(traversal));
      const Image truth = Reference(scene).render().image;
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
        ASSERT_NEAR(image.pixels[i] / truth.pixels[i], 1.0F, 1e-4F)
            << traversal << ", " << corners << " corners";
    }
}

/// Rays that leave the disc in directions of its BSDF all reach the sky.
TEST(NarrowTriangles, DoNotStopPathsThatStartOnThem) {
  Scene scene = disc(*rowCalled(integratorRows(), "path_mats"), 1000);
  Environment sky;
  sky.row = &emitters::constant;
  sky.radiance = glm::dvec3(1.0);
  scene.environment = sky;
  const Image image = render(scene);
  for (const float value : image.pixels) ASSERT_NEAR(value, 0.5F, 1e-6F);
}

}  // namespace
}  // namespace laver::test
