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

Image renderByPortions(const Scene& scene, const RenderOptions& options = {},
                       const std::string& steps = "portions of the tree") {
  Stats stats;
  Image image = Renderer(onTestDevice()).render(scene, options, stats).image;
  const bool byPortions = std::any_of(
      stats.reasons.begin(), stats.reasons.end(),
      [&](const Reason& reason) { return reason.why.find(steps) != std::string::npos; });
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

/// A camera in a closed box of mirrors, each `copies` times, with a small lamp in it. Paths survive
/// a reflection with a probability of 0.99, so that of 640 paths, some have more than 500.
Scene mirrorsWith(std::size_t copies) {
  Scene scene = roomWith(1, *rowCalled(integratorRows(), "path_mis"));
  scene.meshes.resize(3);
  Mesh& lamp = scene.meshes[2];
  for (glm::dvec3& p : lamp.positions) p *= 0.1;
  Mesh box;
  for (int i = 0; i < 8; ++i)
    box.positions.emplace_back(2.0 * (i & 1) - 1.0, (i & 2) - 1.0, 5.0 * (i >> 2) - 4.0);
  // Their normals point inwards.
  const glm::uvec3 faces[] = {{0, 3, 2}, {3, 0, 1}, {4, 7, 5}, {7, 4, 6}, {0, 5, 1}, {5, 0, 4},
                              {2, 7, 6}, {7, 2, 3}, {0, 6, 4}, {6, 0, 2}, {1, 7, 3}, {7, 1, 5}};
  for (std::size_t i = 0; i < copies; ++i)
    box.triangles.insert(box.triangles.end(), std::begin(faces), std::end(faces));
  box.bsdf = {.row = rowCalled(bsdfRows(), "mirror")};
  scene.meshes = {lamp, box};
  scene.lights.clear();
  scene.camera.width = 20;
  scene.camera.height = 16;
  scene.sampler.sampleCount = 2;
  return scene;
}

// 250 mirrors in one place take some hundred iterations for each reflection.
TEST(Portions, OfLongPathsAnswerManyQueriesAtOnce) {
  EXPECT_EQ(differingFloats(render(mirrorsWith(1)),
                            renderByPortions(mirrorsWith(250), {}, "dispatches of 64 queries")),
            0U);
}

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
