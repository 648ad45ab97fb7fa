#include <gtest/gtest.h>

#include "reference/camera.h"
#include "reference/reference.h"
#include "unit/reference_scenes.h"

namespace laver::test {
namespace {

using namespace reference;

void expectNear(glm::dvec3 a, glm::dvec3 b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-15) << i;
}

Camera wideCamera() {
  Camera camera;
  camera.width = 200;
  camera.height = 100;
  camera.fov = 90;
  return camera;
}

TEST(ReferenceCamera, CentreOfTheFilmLooksAlongZ) {
  const CameraRay camera = View(wideCamera(), glm::dvec3(0)).through({100, 50});
  expectNear(camera.ray.origin, {0, 0, 0});
  expectNear(camera.ray.direction, {0, 0, 1});
}

TEST(ReferenceCamera, CornersOfTheFilm) {
  const View view(wideCamera(), glm::dvec3(0));
  expectNear(view.through({0, 0}).ray.direction, {2.0 / 3, 1.0 / 3, 2.0 / 3});
  expectNear(view.through({200, 100}).ray.direction, {-2.0 / 3, -1.0 / 3, 2.0 / 3});
}

TEST(ReferenceCamera, ClipsByPlanes) {
  Camera camera = wideCamera();
  camera.nearClip = 2;
  camera.farClip = 10;
  const CameraRay corner = View(camera, glm::dvec3(0)).through({0, 0});
  EXPECT_NEAR(corner.tmin, 3.0, 1e-15);
  EXPECT_NEAR(corner.tmax, 15.0, 1e-14);
}

TEST(ReferenceCamera, MirroredMovedAndRecentred) {
  Camera camera = wideCamera();
  camera.toWorld[0] = {-1, 0, 0, 0};
  camera.toWorld[3] = {5, 6, 7, 1};
  const CameraRay ray = View(camera, {1, 2, 3}).through({0, 0});
  expectNear(ray.ray.origin, {4, 4, 4});
  expectNear(ray.ray.direction, {-2.0 / 3, 1.0 / 3, 2.0 / 3});
}

TEST(ReferenceCamera, ScaledDirectionKeepsItsLength) {
  Camera camera = wideCamera();
  camera.toWorld = glm::dmat4(glm::dmat3(2.0));
  camera.nearClip = 2;
  const CameraRay corner = View(camera, glm::dvec3(0)).through({0, 0});
  expectNear(corner.ray.direction, {4.0 / 3, 2.0 / 3, 4.0 / 3});
  EXPECT_NEAR(corner.tmin, 3.0, 1e-15);
}

TEST(ReferenceCamera, OriginIsDividedByW) {
  Camera camera = wideCamera();
  camera.toWorld[3] = {2, 4, 6, 2};
  expectNear(View(camera, glm::dvec3(0)).through({0, 0}).ray.origin, {1, 2, 3});
}

// A plane one unit in front of the camera, seen at the film's centre and near its corner.
class ReferenceClipping : public testing::Test {
 protected:
  ReferenceClipping() {
    scene_.meshes = {square(10, 0)};
    scene_.camera = downCamera({0, 0, 1}, 90, 64);
  }
  int seen(double nearClip, double farClip) {
    scene_.camera.nearClip = nearClip;
    scene_.camera.farClip = farClip;
    const Reference renderer(scene_);
    return renderer.closest({32.25, 32.5}).has_value() + renderer.closest({0.5, 0.5}).has_value();
  }
  Scene scene_;
};

TEST_F(ReferenceClipping, Near) {
  EXPECT_EQ(seen(0.999, 100), 2);
  EXPECT_EQ(seen(1.001, 100), 0);
}

TEST_F(ReferenceClipping, Far) {
  EXPECT_EQ(seen(0.1, 1.001), 2);
  EXPECT_EQ(seen(0.1, 0.999), 0);
}

TEST_F(ReferenceClipping, HitIsAtTheFilmPosition) {
  const Reference renderer(scene_);
  const glm::dvec3 point(0.5, -0.25, 0);
  const auto hit = renderer.closest(filmOf(scene_.camera, point));
  ASSERT_TRUE(hit);
  const Mesh& mesh = scene_.meshes[0];
  const glm::uvec3 t = mesh.triangles[hit->triangle];
  const glm::dvec3 a = mesh.positions[t.x];
  expectNear(a + hit->u * (mesh.positions[t.y] - a) + hit->v * (mesh.positions[t.z] - a), point);
  EXPECT_NEAR(hit->t, glm::length(point - glm::dvec3(0, 0, 1)), 1e-15);
}

}  // namespace
}  // namespace laver::test
