// The part of the film whose rays can hit the scene.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/scene_coverage.h"
#include "render/tiling.h"

namespace laver::test {
namespace {

Packed packed(const Scene& scene) { return pack(scene, {}, uploadsOf(scene, {})); }

/// The film position of a point of the world, by the definition of Nori's camera; none if it is
/// behind the camera.
std::optional<glm::dvec2> filmPosition(const Camera& camera, glm::dvec3 p) {
  const glm::dvec3 local(glm::inverse(camera.toWorld) * glm::dvec4(p, 1.0));
  if (local.z <= 0.0) return {};
  const double t = std::tan(glm::radians(camera.fov / 2.0));
  const double aspect = static_cast<double>(camera.height) / camera.width;
  return glm::dvec2((1.0 - local.x / local.z / t) / 2.0 * camera.width,
                    (1.0 - local.y / local.z / t / aspect) / 2.0 * camera.height);
}

Crop pixelAt(glm::dvec2 film) {
  const int x = static_cast<int>(std::floor(film.x)), y = static_cast<int>(std::floor(film.y));
  return {x, y, x + 1, y + 1};
}

class Sees : public testing::TestWithParam<unsigned> {};

TEST_P(Sees, EveryPointOfRandomTrianglesThroughRandomCameras) {
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> unit(0.0, 1.0), around(-1.0, 1.0);
  const auto point = [&] { return glm::dvec3(around(random), around(random), around(random)); };
  std::size_t seen = 0;
  for (int round = 0; round < 200; ++round) {
    Scene scene;
    scene.integrator = {&integrators::normals};
    // A few triangles at some distance, or many around the camera.
    Mesh& mesh = scene.meshes.emplace_back();
    const double size = std::pow(10.0, -2.0 * unit(random));
    for (unsigned i = 0; i < 1 + random() % 60; ++i) {
      const glm::dvec3 a = point();
      for (const glm::dvec3 p : {a, a + size * point(), a + size * point()})
        mesh.positions.push_back(p);
      mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    Camera& camera = scene.camera;
    camera.width = 1 + static_cast<int>(random() % 300);
    camera.height = 1 + static_cast<int>(random() % 300);
    camera.fov = 1.0 + 170.0 * unit(random);
    const glm::dvec3 x = glm::normalize(point()), z = glm::normalize(glm::cross(x, point()));
    const double length = std::pow(10.0, around(random));
    const double mirrored = round % 2 == 0 ? length : -length;
    camera.toWorld =
        glm::dmat4(glm::dvec4(x * mirrored, 0.0), glm::dvec4(glm::cross(z, x) * length, 0.0),
                   glm::dvec4(z * length, 0.0), glm::dvec4(2.0 * point(), 1.0));
    const Coverage coverage = coverageOf(packed(scene));
    for (int i = 0; i < 1000; ++i) {
      const glm::uvec3 t = mesh.triangles[random() % mesh.triangles.size()];
      const double u = unit(random), v = unit(random) * (1.0 - u);
      const auto film = filmPosition(camera, (1.0 - u - v) * mesh.positions[t.x] +
                                                 u * mesh.positions[t.y] + v * mesh.positions[t.z]);
      if (!film || film->x < 0.0 || film->y < 0.0 || film->x >= camera.width ||
          film->y >= camera.height)
        continue;
      ++seen;
      ASSERT_TRUE(coverage.contains(pixelAt(*film))) << round << ' ' << film->x << ' ' << film->y;
    }
  }
  EXPECT_GT(seen, 10000U);
}

INSTANTIATE_TEST_SUITE_P(Seed, Sees, testing::Range(0U, 4U));

/// A square at z = 10 whose corners appear at (x0, y0) and (x1, y1) of 100 x 100 pixels.
Scene square(double x0, double y0, double x1, double y1) {
  Scene scene;
  scene.camera.width = scene.camera.height = 100;
  scene.camera.fov = 90.0;
  const auto at = [](double x, double y) {
    return glm::dvec3(10.0 - x / 5.0, 10.0 - y / 5.0, 10.0);
  };
  scene.meshes.emplace_back();
  scene.meshes[0].positions = {at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)};
  scene.meshes[0].triangles = {{0, 1, 2}, {0, 2, 3}};
  return scene;
}

TEST(Coverage, OfASquareIsTheSquare) {
  const Coverage seen = coverageOf(packed(square(20.5, 30.5, 60.5, 50.5)));
  EXPECT_DOUBLE_EQ(seen.share({20, 30, 61, 51}), 1.0);
  EXPECT_DOUBLE_EQ(seen.share({0, 0, 100, 100}), 41.0 * 21.0 / 1e4);
}

TEST(Coverage, OfASquareBehindOrOutsideTheFilmIsEmpty) {
  Scene scene = square(20, 20, 60, 60);
  scene.camera.toWorld[2] = {0.0, 0.0, -1.0, 0.0};
  EXPECT_EQ(coverageOf(packed(scene)).share({0, 0, 100, 100}), 0.0);
  EXPECT_EQ(coverageOf(packed(square(110, 20, 160, 60))).share({0, 0, 100, 100}), 0.0);
}

TEST(Coverage, OfAFloorUnderTheCameraEndsAtItsFarEdge) {
  Scene scene = square(0, 0, 1, 1);
  scene.meshes[0].positions = {{-50, -1, -50}, {50, -1, -50}, {50, -1, 50}, {-50, -1, 50}};
  const Coverage seen = coverageOf(packed(scene));
  // The far edge appears at y = 51.
  EXPECT_EQ(seen.share({0, 0, 100, 50}), 0.0);
  EXPECT_EQ(seen.share({0, 51, 100, 100}), 1.0);
}

TEST(Coverage, GrowsByColumnsAndRows) {
  Coverage one(20, 20);
  one.add({9, 9, 10, 10});
  const Coverage grown = one.grown(2);
  EXPECT_EQ(grown.share({7, 7, 12, 12}), 1.0);
  EXPECT_DOUBLE_EQ(grown.share({0, 0, 20, 20}), 25.0 / 400.0);
}

bool covers(const std::vector<Crop>& parts, const Coverage& seen, const Crop& area) {
  for (int y = area.y0; y < area.y1; ++y)
    for (int x = area.x0; x < area.x1; ++x) {
      int times = 0;
      for (const Crop& p : parts) times += x >= p.x0 && x < p.x1 && y >= p.y0 && y < p.y1 ? 1 : 0;
      if (times > 1 || (times == 0 && seen.intersects({x, y, x + 1, y + 1}))) return false;
    }
  return true;
}

TEST(CoverageParts, CoverEveryVisiblePixelOnceForAnyCosts) {
  std::mt19937 random(1);
  for (int round = 0; round < 100; ++round) {
    Coverage seen(120, 400);
    for (unsigned i = 0; i < random() % 9; ++i) {
      const int x = static_cast<int>(random() % 110), y = static_cast<int>(random() % 380);
      seen.add(
          {x, y, x + 1 + static_cast<int>(random() % 30), y + 1 + static_cast<int>(random() % 20)});
    }
    const int x0 = static_cast<int>(random() % 60), y0 = static_cast<int>(random() % 100);
    const Crop area{x0, y0, x0 + 1 + static_cast<int>(random() % 60),
                    y0 + 1 + static_cast<int>(random() % 300)};
    const auto each = static_cast<double>(random() % 500);
    const auto parts = seen.parts(area, {each, static_cast<double>(random() % 5)});
    EXPECT_TRUE(covers(parts, seen, area)) << round;
    for (const Crop& p : parts) {
      EXPECT_EQ((p.x0 - area.x0) % static_cast<int>(shared::SLOT_COLUMNS), 0);
      EXPECT_TRUE(p.x0 < p.x1 && p.x1 <= area.x1 && p.y0 >= area.y0 && p.y1 <= area.y1) << round;
    }
  }
}

TEST(CoverageParts, AreFewIfTheyAreExpensiveAndTightIfNot) {
  Coverage seen(80, 40);
  seen.add({0, 2, 8, 10});
  seen.add({64, 20, 80, 33});
  const Crop film{0, 0, 80, 40};
  EXPECT_EQ(seen.parts(film, {1e6, 0}).size(), 1U);
  const auto two = seen.parts(film, {10, 0});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].x1, 8);
  EXPECT_EQ(two[1].x0, 64);
  EXPECT_EQ(two[1].y0, 20);
  EXPECT_EQ(two[1].y1, 33);
  EXPECT_TRUE(Coverage(80, 40).parts(film, {10, 0}).empty());
}

}  // namespace
}  // namespace laver::test
