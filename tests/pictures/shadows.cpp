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

}  // namespace
}  // namespace laver::test
