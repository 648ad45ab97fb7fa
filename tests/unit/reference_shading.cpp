#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "unit/reference_seen.h"

namespace laver::test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(ReferenceDepth, IsOneOverTheDistance) {
  Scene scene = litSquare();
  scene.integrator = {&integrators::depth};
  expectNear(seenAt(scene, {0, 0, 0}), glm::dvec3(0.25));
  expectNear(seenAt(scene, {1, 0.5, 0}), glm::dvec3(1 / std::sqrt(17.25)));
  EXPECT_EQ(Reference(scene).radiance({0.5, 0.5}), glm::dvec3(0));
}

TEST(ReferenceDepth, IsInWorldUnitsUnderAScaledCamera) {
  Scene scene = litSquare();
  scene.integrator = {&integrators::depth};
  const glm::dvec2 film = test::filmOf(scene.camera, {1, 0.5, 0});
  for (int i = 0; i < 3; ++i) scene.camera.toWorld[i] *= 8.0;
  expectNear(Reference(scene).radiance(film), glm::dvec3(1 / std::sqrt(17.25)));
}

TEST(ReferenceNormals, AreAbsoluteValues) {
  Scene scene = litSquare();
  scene.integrator = {&integrators::normals};
  scene.meshes[0].normals.assign(4, glm::dvec3(-0.48, 0.6, -0.64));
  expectNear(seenAt(scene, {0.1, 0, 0}), {0.48, 0.6, 0.64});
}

TEST(ReferenceNormals, AreInterpolatedAndNormalised) {
  Scene scene = litSquare();
  scene.integrator = {&integrators::normals};
  scene.meshes[0].normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
  // (1, -1, 0) has the weights 1/4, 1/2, 1/4 in the first triangle.
  expectNear(seenAt(scene, {1, -1, 0}), glm::dvec3(1, 2, 1) / std::sqrt(6.0));
  scene.meshes[0].triangles[0] = {1, 2, 0};
  expectNear(seenAt(scene, {1, -1, 0}), glm::dvec3(1, 2, 1) / std::sqrt(6.0));
  // The same triangle, but not in the first mesh.
  scene.meshes.insert(scene.meshes.begin(), square(0.25, -6));
  scene.meshes[1].triangles = {{1, 2, 0}, {0, 2, 1}};
  expectNear(seenAt(scene, {1, -1, 0}), glm::dvec3(1, 2, 1) / std::sqrt(6.0));
}

TEST(ReferenceNormals, FallBackToTheTriangle) {
  Scene scene = litSquare();
  scene.integrator = {&integrators::normals};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  scene.meshes[0].normals.assign(4, glm::dvec3(0));
  EXPECT_EQ(seenAt(scene, {0.1, 0, 0}), glm::dvec3(0, 0, 1));
  for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
    scene.meshes[0].normals.assign(4, glm::dvec3(bad, 1, 1));
    EXPECT_EQ(seenAt(scene, {0.1, 0, 0}), glm::dvec3(0, 0, 1));
  }
  scene.meshes[0].normals = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 0}};
  scene.camera = downCamera({0, 0, 4}, 90, 64);
  EXPECT_EQ(Reference(scene).radiance({32, 32}), glm::dvec3(0, 0, 1));
}

TEST(ReferenceNormals, TriangleNormalFollowsTheWindingUnderShading) {
  // For each order of the corners of a horizontal triangle: lit from above only if the winding
  // faces up.
  const glm::dvec3 v[] = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  const unsigned orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int i = 0; i < 6; ++i) {
    Scene scene = litSquare();
    scene.meshes.assign(1, {});
    scene.meshes[0].positions = {v[orders[i][0]], v[orders[i][1]], v[orders[i][2]]};
    scene.meshes[0].triangles = {{0, 1, 2}};
    EXPECT_EQ(seenAt(scene, {0.1, 0.05, 0}).x > 0, i < 3) << i;
  }
}

TEST(ReferenceTies, FirstMeshWins) {
  Scene scene = litSquare();
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes.back().bsdf.set("albedo", glm::dvec3(1));
  const glm::dvec2 film = filmOf(scene.camera, {0.3, -0.2, 0});
  expectNear(Reference(scene).radiance(film) / Reference(litSquare()).radiance(film),
             glm::dvec3(1));
  EXPECT_EQ(Reference(scene).closest(film)->triangle, 0u);
  std::swap(scene.meshes[0].triangles[0], scene.meshes[0].triangles[1]);
  EXPECT_EQ(Reference(scene).closest(film)->triangle, 1u);
}

TEST(ReferenceTies, NumbersRunOnOverTheMeshes) {
  Scene scene = litSquare();
  scene.meshes.insert(scene.meshes.begin(), 2, square(1, -3));
  scene.meshes.insert(scene.meshes.begin() + 1, Mesh{});
  const Reference renderer(scene);
  EXPECT_EQ(renderer.closest(filmOf(scene.camera, {0.3, -0.2, 0}))->triangle, 4u);
  expectNear(renderer.radiance(filmOf(scene.camera, {0, 0, 0})), glm::dvec3(0.2, 1.0, 2.4) / pi);
}

}  // namespace
}  // namespace laver::test
