// Which of two planes is nearer where double precision cannot say.
#include <gtest/gtest.h>

#include "reference/exact_depth.h"
#include "reference/reference.h"

namespace laver::test {
namespace {

using glm::dvec3;
using reference::compareDepths;
using reference::Corners;

TEST(ReferenceTies, PlanesAreComparedExactly) {
  const reference::ExactRay ray{dvec3(0.1, 0.2, 0.3), dvec3(1e-17, 0.0, 0.0), dvec3(0.3, 0.1, 1.0)};
  const Corners plane{dvec3(-1, -1, 4), dvec3(3, -1, 4), dvec3(-1, 3, 4)};
  const Corners same{dvec3(7, 5, 4), dvec3(-2, 9, 4), dvec3(0, 0, 4)};
  EXPECT_EQ(compareDepths(ray, plane, same), 0);
  // One corner is nearer by an ulp: the planes differ by less than any t in double precision.
  Corners nearer = same;
  nearer[0].z = std::nextafter(4.0, 0.0);
  const int order = compareDepths(ray, plane, nearer);
  EXPECT_NE(order, 0);
  EXPECT_EQ(compareDepths(ray, nearer, plane), -order);
  std::swap(nearer[0], nearer[1]);  // the other winding
  EXPECT_EQ(compareDepths(ray, plane, nearer), order);
}

/// Two coincident squares that are cut along different diagonals, on a plane that is seen askew.
TEST(ReferenceTies, OfCoincidentFacesTheFirstOneShows) {
  Scene scene;
  scene.integrator = {&integrators::normals};
  for (const bool turned : {false, true}) {
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    if (turned)
      mesh.triangles = {{1, 2, 3}, {1, 3, 0}};
    else
      mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  }
  scene.camera.width = scene.camera.height = 64;
  scene.camera.fov = 40.0;
  const dvec3 eye(0.3, 0.7, 4.0), z = glm::normalize(-eye);
  const dvec3 x = glm::normalize(glm::cross(dvec3(0, 1, 0), z));
  scene.camera.toWorld = {glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0),
                          glm::dvec4(eye, 1)};
  const Reference reference(scene);
  int hits = 0;
  for (int y = 0; y < 64; ++y)
    for (int i = 0; i < 64; ++i)
      if (const auto hit = reference.closest(glm::dvec2(i + 0.37, y + 0.61))) {
        ++hits;
        EXPECT_LT(hit->triangle, 2U) << i << ' ' << y;
      }
  EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace laver::test
