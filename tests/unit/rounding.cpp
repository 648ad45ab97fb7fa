// The bound of the movement by rounding, against the kernels' own arithmetic.
#include "reference/rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "reference/ray.h"
#include "render/packed.h"
#include "shared/triangle.h"

namespace laver::test {
namespace {

using glm::dvec2;
using glm::dvec3;

/// A triangle in front of a randomly oriented camera.
Scene randomScene(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0), fov(5.0, 150.0);
  const auto point = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  Scene scene;
  Mesh mesh;
  mesh.positions = {point(), point(), point()};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes = {mesh};
  const dvec3 z = glm::normalize(point()), x = glm::normalize(glm::cross(z, point()));
  scene.camera.toWorld = glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0),
                                    glm::dvec4(z, 0.0), glm::dvec4(3.0 * point(), 1.0));
  scene.camera.fov = fov(random);
  scene.camera.width = 1280;
  scene.camera.height = 720;
  return scene;
}

/// The exact film position of the direction that the kernels compute in float for `film`.
dvec2 filmOf(const Camera& camera, const shared::Params& params, glm::vec2 film) {
  const float x = static_cast<float>(camera.width) - 2.0F * film.x;
  const float y = static_cast<float>(camera.height) - 2.0F * film.y;
  const glm::vec3 d =
      glm::vec3(params.columnX) * x + glm::vec3(params.columnY) * y + glm::vec3(params.columnZ);
  const dvec3 local = glm::transpose(glm::dmat3(camera.toWorld)) * dvec3(d);
  const double pixel = 2.0 * std::tan(glm::radians(camera.fov) / 2.0) / camera.width;
  return (dvec2(camera.width, camera.height) - 2.0 * dvec2(local) / local.z / pixel) * 0.5;
}

TEST(Rounding, CameraRaysStayWithinTheirBoundAndComeNearIt) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  double largest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Scene scene = randomScene(random);
    const Packed data = pack(scene, {}, uploadsOf(scene, {}));
    const Rounding rounding(scene);
    for (int j = 0; j < 200; ++j) {
      const glm::vec2 film(1280.0F * unit(random), 720.0F * unit(random));
      const double moved = glm::length(filmOf(scene.camera, data.params, film) - dvec2(film));
      const double bound = rounding.ofHit(film, std::numeric_limits<double>::infinity());
      ASSERT_LE(moved, bound) << film.x << ", " << film.y << " at " << scene.camera.fov;
      largest = std::max(largest, moved / bound);
    }
  }
  // The worst cases of some ten roundings rarely coincide, and the slopes' part of the bound is not
  // tested here.
  EXPECT_GT(largest, 0.2);
}

/// A ray, its exact position relative to a triangle, and the result of the float test.
struct Near {
  double beyond = 0.0;  ///< distance of the ray from the border, positive outside
  double bound = 0.0;
  bool inside = false;
};

Near nearEdge(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  const auto point = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  const glm::vec3 origin = 2.0F * point(), a = point(), b = point(), c = point();
  const float share = 0.5F + 0.5F * unit(random);
  const glm::vec3 direction = a + (b - a) * share - origin;
  const reference::Shear exact({dvec3(origin), dvec3(direction)});
  const dvec2 pa(exact(dvec3(a))), pb(exact(dvec3(b))), pc(exact(dvec3(c)));
  const auto cross = [](dvec2 p, dvec2 q) { return p.x * q.y - p.y * q.x; };
  const double side = cross(pb - pa, -pa), within = cross(pb - pa, pc - pa);
  const shared::Shear shear = shared::shearOf(direction);
  Near near;
  near.beyond = -side * (within < 0.0 ? -1.0 : 1.0) / glm::length(pb - pa);
  near.bound =
      std::max(cornerShift(a - origin, direction, pa), cornerShift(b - origin, direction, pb)) +
      edgeShift(pa, pb);
  near.inside =
      shared::edgesOf(shear, shared::permute(shear, a - origin), shared::permute(shear, b - origin),
                      shared::permute(shear, c - origin))
          .inside;
  return near;
}

TEST(Rounding, TheTriangleTestMovesEdgesWithinTheirBoundAndComesNearIt) {
  std::mt19937 random(2);
  double largest = 0.0;
  int wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    const Near near = nearEdge(random);
    if (near.inside == (near.beyond <= 0.0)) continue;
    ++wrong;
    ASSERT_LE(std::abs(near.beyond), near.bound);
    largest = std::max(largest, std::abs(near.beyond) / near.bound);
  }
  EXPECT_GT(wrong, 1000);  // rays at edges differ
  EXPECT_GT(largest, 0.1);
}

TEST(Rounding, GrowsWithTheCamerasDistanceFromTheScene) {
  std::mt19937 random(3);
  Scene scene = randomScene(random);
  const dvec2 middle(640.0, 360.0);
  const double near = Rounding(scene).ofHit(middle, 1.0);
  scene.camera.toWorld[3] *= glm::dvec4(100.0, 100.0, 100.0, 1.0);
  const double far = Rounding(scene).ofHit(middle, 1.0);
  EXPECT_GT(far, 10.0 * near);
  EXPECT_GT(Rounding(scene).ofShading(middle, 1.0), far);
  EXPECT_LT(Rounding(scene).ofHit(middle, 100.0), 0.1 * far);
}

}  // namespace
}  // namespace laver::test
