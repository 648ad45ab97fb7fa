#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "unit/reference_seen.h"

namespace laver::test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(ReferenceWhitted, BelowTheLight) {
  expectNear(seenAt(litSquare(), {0, 0, 0}), glm::dvec3(0.2, 1.0, 2.4) / pi);
}

TEST(ReferenceWhitted, ObliquePointAndTwoLights) {
  Scene scene = litSquare();
  scene.lights.push_back({{1.5, 0, 1}, {1, 1, 1}});
  // From (1.5, 0, 0): to the first light (-1.5, 0, 2), r = 2.5, cosine 0.8; to the second r = 1.
  const glm::dvec3 incoming = glm::dvec3(4, 8, 12) / 6.25 * 0.8 + glm::dvec3(1);
  expectNear(seenAt(scene, {1.5, 0, 0}), incoming * scene.meshes[0].bsdf.color("albedo") / pi);
}

TEST(ReferenceWhitted, MissIsBlack) {
  EXPECT_EQ(Reference(litSquare()).radiance({0.5, 0.5}), glm::dvec3(0));
}

TEST(ReferenceWhitted, LightBehindTheNormalIsBlack) {
  Scene scene = litSquare();
  scene.lights[0].position.z = -2;
  EXPECT_EQ(seenAt(scene, {0, 0, 0}), glm::dvec3(0));
}

TEST(ReferenceWhitted, BackSideIsBlackWhereverTheLight) {
  Scene scene = litSquare();
  for (glm::uvec3& t : scene.meshes[0].triangles) std::swap(t.x, t.y);
  EXPECT_EQ(seenAt(scene, {0, 0, 0}), glm::dvec3(0));
  scene.lights[0].position.z = -2;
  EXPECT_EQ(seenAt(scene, {0, 0, 0}), glm::dvec3(0));
}

TEST(ReferenceWhitted, SignsAreThoseOfTheShadingNormal) {
  Scene scene = litSquare();
  scene.meshes[0].normals.assign(4, glm::dvec3(0, 0.6, 0.8));
  expectNear(seenAt(scene, {0, 0, 0}), 0.8 * glm::dvec3(0.2, 1.0, 2.4) / pi);
  // Below the shading normal's horizon, above the triangle's.
  scene.lights[0].position = {0, -2, 0.5};
  EXPECT_EQ(seenAt(scene, {0, 0, 0}), glm::dvec3(0));
  // Above both, but the shading normal turns away from the camera.
  scene.meshes[0].normals.assign(4, glm::dvec3(0, 0.8, -0.6));
  scene.lights[0].position = {0, 2, 0.5};
  EXPECT_EQ(seenAt(scene, {0, 0, 0}), glm::dvec3(0));
  scene.meshes[0].normals.assign(4, glm::dvec3(0, 0.6, 0.8));
  // The reverse: no other surface is in between, so the light counts.
  scene.lights[0].position = {0, 2, -0.5};
  EXPECT_GT(seenAt(scene, {0, 0, 0}).x, 0);
}

class ReferenceShadow : public testing::TestWithParam<double> {};

TEST_P(ReferenceShadow, BlockerAtHeightBetween) {
  Scene scene = litSquare();
  scene.camera = downCamera({1, 0, 4}, 60, 64);
  scene.meshes.push_back(square(0.25, GetParam()));
  scene.lights[0].position = {-1, 0, 2};
  // The line from the light to (x, 0, 0) passes through the centre of the blocker.
  const double height = GetParam();
  const double x = height / (2 - height);
  EXPECT_EQ(seenAt(scene, {x + 0.1, 0, 0}), glm::dvec3(0)) << height;
  EXPECT_GT(seenAt(scene, {x + 0.7, 0, 0}).x, 0) << height;
}

INSTANTIATE_TEST_SUITE_P(Heights, ReferenceShadow, testing::Values(1.0, 0.5));

TEST(ReferenceWhitted, ContactGapIsSeen) {
  Scene scene = litSquare();
  scene.camera = downCamera({0.75, 0, 4}, 60, 64);
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    scene.meshes.resize(2);
    scene.meshes.push_back(square(0.25, gap));
    // Under a grazing light the line to (0.5, 0, 0) passes through the centre of the blocker, at x
    // = -0.5.
    scene.lights[0].position = {-1, 0, gap * 3};
    EXPECT_EQ(seenAt(scene, {0.5, 0, 0}), glm::dvec3(0)) << gap;
    scene.lights[0].position = {-1, 0, gap * 1.5};
    EXPECT_GT(seenAt(scene, {0.5, 0, 0}).x, 0) << gap;
  }
}

TEST(ReferenceWhitted, NothingBeyondTheLightBlocks) {
  Scene scene = litSquare();
  scene.camera = downCamera({0, 0, 1.5}, 60, 64);
  const glm::dvec3 open = seenAt(scene, {0.1, 0, 0});
  scene.meshes.push_back(square(1, 2.0 + 1e-12));
  scene.meshes.push_back(square(1, -1e-12));
  expectNear(seenAt(scene, {0.1, 0, 0}), open, 1e-11);
}

TEST(ReferenceWhitted, LightOnTheSurfaceGivesNothing) {
  Scene scene = litSquare();
  scene.lights[0].position = {0, 0, 0};
  scene.camera = downCamera({0, 0, 4}, 90, 64);
  EXPECT_EQ(Reference(scene).radiance({32, 32}), glm::dvec3(0));
}

TEST(ReferenceWhitted, NoSelfShadowAtGrazingAngles) {
  // An 8x8 grid in a tilted plane, far from 0, under lights from near to very far.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-0.95, 0.95);
  const glm::dvec3 centre(1e5, -3e5, 2e5);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 0.2, 0.9));
  const glm::dvec3 s = glm::normalize(glm::cross(normal, glm::dvec3(0, 1, 0)));
  const glm::dvec3 t = glm::cross(normal, s);
  Scene scene = litSquare();
  scene.meshes.assign(1, {});
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i) {
      scene.meshes[0].positions.push_back(centre + (i / 4.0 - 1) * s + (j / 4.0 - 1) * t);
    }
  }
  for (unsigned j = 0; j < 8; ++j) {
    for (unsigned i = 0; i < 8; ++i) {
      const unsigned a = 9 * j + i;
      scene.meshes[0].triangles.emplace_back(a, a + 1, a + 10);
      scene.meshes[0].triangles.emplace_back(a, a + 10, a + 9);
    }
  }
  scene.camera = downCamera(centre + glm::dvec3(0, 0, 3), 50, 64);
  for (const double distance : {1.0, 10.0, 1e2, 1e4, 1e6}) {
    scene.lights[0] = {centre + distance * (s + 0.01 * normal), glm::dvec3(distance * distance)};
    const Reference renderer(scene);
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 point = centre + unit(random) * s + unit(random) * t;
      ASSERT_GT(renderer.radiance(filmOf(scene.camera, point)).x, 0) << distance;
    }
  }
}

TEST(ReferenceWhitted, ExactTranslationChangesNoBit) {
  Scene near = litSquare(), far = near;
  const glm::dvec3 shift(0x1p20, -0x1p22, 0x1p21);
  for (Mesh& mesh : far.meshes) {
    for (glm::dvec3& position : mesh.positions) position += shift;
  }
  far.lights[0].position += shift;
  far.camera.toWorld[3] += glm::dvec4(shift, 0);
  const Reference a(near), b(far);
  for (int i = 0; i < 64; ++i) {
    const glm::dvec2 film(i + 0.3, 63.7 - 0.7 * i);
    EXPECT_EQ(a.radiance(film), b.radiance(film)) << i;
  }
}

}  // namespace
}  // namespace laver::test
