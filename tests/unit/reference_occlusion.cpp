// Average visibility and ambient occlusion of the reference against analytic values.
#include <gtest/gtest.h>

#include <numbers>

#include "unit/reference_seen.h"

namespace laver::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A floor with a square plate of half-width 1 over its origin; the camera is between the two.
Scene underPlate(const IntegratorRow& integrator, double height) {
  Scene scene;
  scene.integrator = {&integrator};
  scene.meshes = {test::square(3, 0), test::square(1, height)};
  scene.camera = test::downCamera({0.2, 0, 0.5 * height}, 60, 64);
  return scene;
}

/// Mean radiance at the floor's origin over a grid of random numbers.
double meanAt(const Scene& scene) {
  const Reference reference(scene);
  const glm::dvec2 film = filmOf(scene.camera, {0, 0, 0});
  constexpr int side = 400;
  double sum = 0;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      sum += reference.radiance(film, (glm::dvec2(i, j) + 0.5) / double{side}).x;
  return sum / (side * side);
}

// The border of the plate crosses about 4 * 400 of the grid's 160,000 cells, half of which may be
// wrong.
constexpr double kTolerance = 2e-3;

TEST(ReferenceOcclusion, AverageVisibilityIsTheShareOfTheSolidAngle) {
  for (const double h : {0.3, 1.0, 2.0}) {
    const double angle = 4 * std::atan(1 / (h * std::sqrt(2 + h * h)));
    EXPECT_NEAR(meanAt(underPlate(integrators::averageVisibility, h)), 1 - angle / (2 * pi),
                kTolerance);
  }
}

TEST(ReferenceOcclusion, AmbientOcclusionIsTheFormFactor) {
  for (const double h : {0.3, 1.0, 2.0}) {
    const double a = 1 / std::sqrt(1 + h * h);
    EXPECT_NEAR(meanAt(underPlate(integrators::ambientOcclusion, h)), 1 - 4 / pi * a * std::atan(a),
                kTolerance);
  }
}

TEST(ReferenceOcclusion, AverageVisibilityEndsAtItsLength) {
  Scene scene = underPlate(integrators::averageVisibility, 0.5);
  scene.integrator.set("length", 0.499);
  EXPECT_EQ(meanAt(scene), 1.0);
  // Directions with a cosine above h / length hit the plate inside its border.
  scene.integrator.set("length", 0.8);
  EXPECT_NEAR(meanAt(scene), 0.5 / 0.8, kTolerance);
}

TEST(ReferenceOcclusion, AMissIsOneForAvAndZeroForAo) {
  const Scene av = underPlate(integrators::averageVisibility, 1);
  const Scene ao = underPlate(integrators::ambientOcclusion, 1);
  Scene away = av;
  away.camera.toWorld[2] = -away.camera.toWorld[2];  // up, away from the plate
  away.meshes.pop_back();
  EXPECT_EQ(Reference(away).radiance({32, 32}), glm::dvec3(1));
  away.integrator = ao.integrator;
  EXPECT_EQ(Reference(away).radiance({32, 32}), glm::dvec3(0));
}

TEST(ReferenceOcclusion, TheHemisphereIsTheShadingNormals) {
  // The normals point below the floor, where nothing occludes.
  Scene scene = underPlate(integrators::ambientOcclusion, 1);
  scene.meshes[0].normals.assign(4, glm::dvec3(0, 0, -1));
  EXPECT_EQ(meanAt(scene), 1.0);
}

}  // namespace
}  // namespace laver::test
