// Differences that rounding explains, and others.
#include "lab/explain/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace laver::test {
namespace {

using glm::dvec2;

/// A square of half-width 1 at z = 4, seen from 0, with an edge at film position 96 of 128. The
/// part up to 64 lies in the shadow of another square, which is outside the film.
Scene halfLitSquare() {
  const auto square = [](double x0, double x1, double z) {
    Mesh mesh;
    mesh.positions = {{x0, -1.0, z}, {x1, -1.0, z}, {x1, 1.0, z}, {x0, 1.0, z}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
    return mesh;
  };
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes = {square(-1.0, 1.0, 4.0), square(4.0, 6.0, 2.0)};
  scene.lights = {{glm::dvec3(8.0, 0.0, 0.0), glm::dvec3(100.0)}};
  scene.camera.width = scene.camera.height = 128;
  scene.camera.fov = 2.0 * glm::degrees(std::atan(0.5));
  return scene;
}

TEST(Judge, AnotherHitIsExplainedNearAnEdgeOnly) {
  const Scene scene = halfLitSquare();
  const Reference reference(scene);
  const Judge judge(scene, reference);
  const double bound = judge.rounding().ofHit(dvec2(96.0, 50.0), std::sqrt(17.0));
  EXPECT_GT(bound, 1e-5);
  EXPECT_LT(bound, 1e-3);
  for (const double side : {-1.0, 1.0}) {
    const dvec2 near(96.0 + 0.9 * side * bound, 50.0), apart(96.0 + 1.2 * side * bound, 50.0);
    EXPECT_TRUE(judge.otherHit(near));
    EXPECT_TRUE(judge.mayHit(near, std::nullopt, std::numeric_limits<double>::infinity()));
    EXPECT_TRUE(judge.mayHit(near, 0, 4.0) || judge.mayHit(near, 1, 4.0));
    EXPECT_FALSE(judge.mayHit(near, 2, 4.0));
    EXPECT_FALSE(judge.otherHit(apart));
    EXPECT_FALSE(judge.mayHit(apart, 2, 4.0));
  }
}

TEST(Judge, AnotherValueIsExplainedNearTheBorderOfAShadowOnly) {
  const Scene scene = halfLitSquare();
  const Reference reference(scene);
  const Judge judge(scene, reference);
  const dvec2 numbers(0.5);
  const double lit = reference.radiance(dvec2(65.0, 50.0)).x;
  EXPECT_GT(lit, 0.01);
  EXPECT_EQ(reference.radiance(dvec2(63.0, 50.0)).x, 0.0);
  const double bound = judge.rounding().ofShading(dvec2(64.0, 50.0), 4.0);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(judge.otherValue(dvec2(64.0 + 0.9 * side * bound, 50.0), numbers, 0.9 * lit));
    EXPECT_FALSE(judge.otherValue(dvec2(64.0 + 0.9 * side * bound, 50.0), numbers, 1.1 * lit));
    EXPECT_FALSE(judge.otherValue(dvec2(64.0 + 1.2 * side * bound, 50.0), numbers, 0.01 * lit));
  }
}

TEST(Judge, ConsidersEveryChannel) {
  Scene scene = halfLitSquare();
  scene.integrator = {&integrators::albedo};
  const dvec2 edge(96.0, 50.0);
  for (int channel = 0; channel < 3; ++channel) {
    glm::dvec3 albedo(0.0);
    albedo[channel] = 0.5;
    scene.meshes[0].bsdf.set("albedo", albedo);
    const Reference reference(scene);
    EXPECT_TRUE(Judge(scene, reference).otherValue(edge, dvec2(0.5), 0.4)) << channel;
  }
}

TEST(Judge, AWrongPixelIsUnexplainedAndSoIsNaN) {
  Scene scene = halfLitSquare();
  const Reference reference(scene);
  const Judge judge(scene, reference);
  const Image truth = reference.render().image;
  for (const float wrong : {0.3F, std::numeric_limits<float>::quiet_NaN()}) {
    Image image = truth;
    image.at(80, 40, 1) = wrong;
    const PixelDifferences found = explainPixels(image, truth, judge, 1e-4);
    EXPECT_EQ(found.differing, 1U);
    EXPECT_EQ(found.unexplained, 1U);
    EXPECT_EQ(found.first.find("pixel 80, 40 differs by "), 0U) << found.first;
  }
}

}  // namespace
}  // namespace laver::test
