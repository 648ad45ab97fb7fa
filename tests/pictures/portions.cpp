// Walks that exceed a driver's loop iterations go on in further dispatches, without changing a bit.
#include "bvh/portions.h"

#include <algorithm>

#include "pictures/adaptive.h"

namespace laver::test {
namespace {

// Enough for lavapipe to cut the walk of one query short, after 65,535 iterations.
constexpr std::size_t kCopies = 70000;

/// A room with a lamp, a mirror and a point light, and a small triangle that is there `copies`
/// times.
Scene roomWith(std::size_t copies, const IntegratorRow& integrator) {
  Scene scene;
  scene.integrator = {&integrator};
  const double a = 1.0;
  scene.meshes = {quad({{{-a, -a, -a}, {-a, -a, a}, {a, -a, a}, {a, -a, -a}}}, {0.7, 0.7, 0.7}),
                  quad({{{-a, -a, a}, {-a, a, a}, {a, a, a}, {a, -a, a}}}, {0.2, 0.6, 0.7}),
                  quad({{{-0.3, 0.9, -0.3}, {0.3, 0.9, -0.3}, {0.3, 0.9, 0.3}, {-0.3, 0.9, 0.3}}},
                       {0.2, 0.2, 0.2})};
  scene.meshes[2].light = AreaLight{{8.0, 7.0, 5.0}};
  Mesh& sphere = scene.meshes.emplace_back();
  sphere.sphere = Sphere{{-0.4, -0.6, 0.3}, 0.4};
  sphere.bsdf = {.row = rowCalled(bsdfRows(), "mirror")};
  Mesh& stack = scene.meshes.emplace_back();
  stack.positions = {{0.2, -0.6, -0.5}, {0.5, -0.6, -0.5}, {0.4, -0.3, -0.4}};
  stack.triangles.assign(copies, {0, 1, 2});
  stack.bsdf.set("albedo", glm::dvec3(0.8, 0.3, 0.1));
  scene.lights = {{{-0.8, 0.5, -0.8}, {2.0, 2.0, 2.0}}};
  scene.camera.toWorld[3] = glm::dvec4(0.0, 0.0, -3.5, 1.0);
  scene.camera.fov = 40.0;
  scene.camera.width = 40;
  scene.camera.height = 33;
  scene.sampler.sampleCount = 5;
  return scene;
}

Image renderByPortions(const Scene& scene, const RenderOptions& options = {}) {
  Stats stats;
  Image image = Renderer(onTestDevice()).render(scene, options, stats).image;
  const bool byPortions =
      std::any_of(stats.reasons.begin(), stats.reasons.end(), [](const Reason& reason) {
        return reason.why.find("portions of the tree") != std::string::npos;
      });
  EXPECT_EQ(loopsEndEarly().value_or(byPortions), byPortions) << testDeviceInfo().driver;
  return image;
}

class Portions : public testing::TestWithParam<std::string> {};

TEST_P(Portions, GiveTheBitsOfOneWalk) {
  const IntegratorRow& integrator = *rowCalled(integratorRows(), GetParam());
  EXPECT_EQ(differingFloats(render(roomWith(1, integrator)),
                            renderByPortions(roomWith(kCopies, integrator))),
            0U);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Portions,
                         testing::Values("depth", "ao", "direct_whitted", "direct_ems", "path_mis",
                                         "whitted"));

TEST(Portions, ServeAdaptiveSampling) {
  Scene one = roomWith(1, integrators::directWhitted);
  Scene many = roomWith(kCopies, integrators::directWhitted);
  one.sampler.sampleCount = many.sampler.sampleCount = 64;
  EXPECT_EQ(differingFloats(render(one, onTestDevice(), adaptive(0.05)),
                            renderByPortions(many, adaptive(0.05))),
            0U);
}

TEST(Portions, ServeLayersAndManyLights) {
  Scene one = roomWith(1, integrators::directWhitted);
  for (int i = 0; i < 20; ++i)
    one.lights.push_back({{-0.9 + 0.09 * i, 0.5, -0.8}, {0.1, 0.1, 0.05 * i}});
  Scene many = one;
  many.meshes.back().triangles.assign(kCopies, {0, 1, 2});
  RenderOptions options;
  options.layers = {&layers::normals, &layers::albedo};
  EXPECT_EQ(differingFloats(render(one, onTestDevice(), options), renderByPortions(many, options)),
            0U);
}

// More samples than are traced together.
TEST(Portions, CoverLargePasses) {
  Scene one = roomWith(1, integrators::directWhitted);
  one.camera.width = 100;
  one.camera.height = 90;
  one.sampler.sampleCount = 21;
  Scene many = one;
  many.meshes.back().triangles.assign(kCopies, {0, 1, 2});
  EXPECT_EQ(differingFloats(render(one), renderByPortions(many)), 0U);
}

}  // namespace
}  // namespace laver::test
