// Pictures of scenes whose parts differ much in size, by integrators and cameras of all kinds:
// device against reference, pixel by pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pictures/harness.h"
#include "reference/reference.h"
#include "stability/scale_scenes.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// Share of the picture's values that differ from the reference by more than 1e-4 of the largest.
double differing(const Scene& scene) {
  const Image image = render(scene);
  const Image truth = Reference(scene).render().image;
  const double largest = static_cast<double>(*std::ranges::max_element(truth.pixels));
  EXPECT_GT(largest, 0.0);
  double wrong = 0.0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i)
    wrong += std::abs(static_cast<double>(image.pixels[i] - truth.pixels[i])) > 1e-4 * largest;
  return wrong / static_cast<double>(truth.pixels.size());
}

std::vector<std::pair<const char*, Scene>> farScenes() {
  return {{"level ground", onGround(1e8, 1e8)},
          {"tilted ground", onGround(1e8, 1e8, 0.3)},
          {"sphere", onSphere(6.4e6)},
          {"mesh planet", onPlanet(6.4e6)},
          {"stray triangle", withStray(dvec3(1e7, 2e7, -1e8))},
          {"far camera", seenFromAfar(1e4, false)}};
}

/// A ray that rounding moves may pass on the other side of an edge; so some pixels differ at
/// ordinary scale, too. Wrong lights or shadows of far parts show in most pixels.
template <class Change>
void expectAsUsual(const Change& change) {
  const double usual = differing(change(onGround(10.0, 10.0)));
  EXPECT_LT(usual, 0.01);
  for (const auto& [name, scene] : farScenes())
    EXPECT_LT(differing(change(scene)), usual + 0.01) << name;
}

Scene integratedBy(Scene scene, const char* name) {
  scene.integrator = {rowCalled(integratorRows(), name)};
  scene.sampler.sampleCount = 4;
  return scene;
}

/// A triangle that emits.
struct Lamp {
  dvec3 place;
  double size, radiance;
};
constexpr Lamp kLamp{dvec3(1.0, 4.0, 1.0), 0.4, 40.0};
constexpr Lamp kSun{dvec3(3e6, 9e6, 2e6), 1e5, 3e4};

Scene litBy(Scene scene, const Lamp& lamp) {
  scene.lights.clear();
  Mesh& mesh = scene.meshes.emplace_back();
  const dvec3 p = lamp.place;
  mesh.positions = {p, p + dvec3(lamp.size, 0.0, 0.0), p + dvec3(0.0, 0.0, lamp.size)};
  mesh.triangles = {{0, 1, 2}};
  mesh.light = AreaLight{dvec3(lamp.radiance)};
  return scene;
}

Scene underSky(Scene scene) {
  scene.environment = Environment();
  scene.environment->radiance = dvec3(0.2, 0.3, 0.5);
  return scene;
}

/// In focus at 0.9 of the distance of the ball, behind which it is blurred by a ninth of the lens's
/// radius.
Scene throughLens(Scene scene) {
  const double distance = glm::length(dvec3(scene.camera.toWorld[3]) - dvec3(0.0, 1.0, 0.0));
  scene.camera.row = &cameras::thinlens;
  scene.camera.lensRadius = distance < 100.0 ? 0.3 : 3.0;
  scene.camera.focalDistance = 0.9 * distance;
  return scene;
}

TEST(ScalePictures, PathsFromALamp) {
  expectAsUsual([](const Scene& scene) { return litBy(integratedBy(scene, "path_mis"), kLamp); });
}

TEST(ScalePictures, PathsFromAFarAndLargeLamp) {
  expectAsUsual([](const Scene& scene) { return litBy(integratedBy(scene, "path_mis"), kSun); });
}

TEST(ScalePictures, PathsFromALampAndTheSky) {
  expectAsUsual(
      [](const Scene& scene) { return underSky(litBy(integratedBy(scene, "path_mis"), kLamp)); });
}

TEST(ScalePictures, PathsThroughALens) {
  expectAsUsual([](const Scene& scene) {
    return throughLens(underSky(litBy(integratedBy(scene, "path_mis"), kLamp)));
  });
}

TEST(ScalePictures, PointLightsThroughALens) {
  expectAsUsual(
      [](const Scene& scene) { return throughLens(integratedBy(scene, "direct_whitted")); });
}

TEST(ScalePictures, Occlusion) {
  expectAsUsual([](const Scene& scene) { return integratedBy(scene, "ao"); });
  expectAsUsual([](Scene scene) {
    scene = integratedBy(scene, "av");
    scene.integrator.set("length", 2.0);
    return scene;
  });
}

TEST(ScalePictures, AnIntegratorsOwnLight) {
  expectAsUsual([](Scene scene) {
    scene = integratedBy(scene, "simple");
    scene.integrator.set("position", dvec3(2.0, 5.0, 3.0));
    scene.integrator.set("energy", dvec3(2000.0));
    return scene;
  });
}

}  // namespace
}  // namespace laver::test
