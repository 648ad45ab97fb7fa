// A flat plane lit at grazing angles does not shadow itself, for any size, position, and distance
// of camera and light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "render/packed.h"
#include "stability/naive.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

using glm::dvec3;

struct Setting {
  double scale, offset, camera, light;  ///< the last three in units of the scale
  int cells = 8;
};

/// Points where camera rays hit the plane, and the origins of their shadow rays.
struct Lit {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> ids;
};

/// Cells of a tilted plane of half-width `scale`, and a frame for placing camera and light.
struct Plane {
  explicit Plane(const Setting& s) : setting(s) {
    normal = glm::normalize(dvec3(0.3, -0.5, 0.8));
    u = glm::normalize(glm::cross(normal, dvec3(0.1, 1.0, 0.2)));
    v = glm::cross(normal, u);
    centre = s.scale * s.offset * dvec3(1.0, -0.6, 0.7);
    scene.meshes = {gridMesh(s.cells, [&](double x, double y) { return at(x, y, 0.0); })};
  }
  dvec3 at(double x, double y, double height) const {
    return centre + setting.scale * (x * u + y * v + height * normal);
  }
  Setting setting;
  dvec3 normal, u, v, centre;
  Scene scene;
};

constexpr std::size_t kFew = 12288;                   // targets of the naive method
constexpr double kElevations[] = {0.3, 0.03, 0.003};  // radians of the light over the plane
dvec3 lightOf(const Plane& plane, double elevation) {
  const double d = plane.setting.light;
  return plane.at(d * std::cos(elevation), 0.0, d * std::sin(elevation));
}

/// Targets of camera rays on the plane, away from its border.
std::vector<glm::dvec2> targets(std::uint64_t count) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-0.99, 0.99);
  std::vector<glm::dvec2> all(count);
  for (auto& t : all) t = {place(random), place(random)};
  return all;
}

/// False shadows with Nori's method: the scene's coordinates as floats, mint 1e-4.
std::uint64_t naiveShadows(const Plane& plane, const std::vector<glm::dvec2>& where,
                           Bitmap* picture) {
  const auto triangles = listedTriangles(plane.scene.meshes[0]);
  const auto nearest = [&](glm::vec3 o, glm::vec3 d, float mint, float maxt) {
    TestHit best{maxt, 0, 0, shared::NO_HIT}, hit{};
    for (const auto& t : triangles)
      if (naive::moellerTrumbore(o, d, t, mint, best.t, hit)) best = hit;
    return best;
  };
  const glm::vec3 eye(plane.at(0.1, -0.2, plane.setting.camera));
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    const glm::vec3 d = glm::normalize(glm::vec3(plane.at(where[i].x, where[i].y, 0.0)) - eye);
    const auto hit = nearest(eye, d, 1e-4F, INFINITY);
    if (hit.id == shared::NO_HIT) continue;
    const auto& t = triangles[hit.id];
    const glm::vec3 p = t.a * (1 - hit.u - hit.v) + t.b * hit.u + t.c * hit.v;
    const glm::vec3 direction = glm::vec3(lightOf(plane, kElevations[i % 3])) - p;
    const float length = glm::length(direction);
    const bool blocked =
        nearest(p, direction / length, 1e-4F, length * (1 - 1e-4F)).id != shared::NO_HIT;
    count += blocked ? 1 : 0;
    if (picture != nullptr && !blocked) picture->pixels[i] = {255, 255, 255};
  }
  return count;
}

/// Ours: for each target, whether it is lit, with the scene as the renderer packs it.
std::vector<std::uint32_t> sightOf(const Plane& plane, const Packed& data, Subject& subject,
                                   const std::vector<glm::dvec2>& where, double elevation) {
  const glm::vec3 eye(data.space.apply(plane.at(0.1, -0.2, plane.setting.camera)));
  std::vector<TestRay> rays;
  rays.reserve(where.size());
  for (const auto& w : where)
    rays.push_back(rayOf(eye, glm::vec3(data.space.apply(plane.at(w.x, w.y, 0.0)) - dvec3(eye))));
  const glm::vec3 light(data.space.apply(lightOf(plane, elevation)));
  const auto hits = subject.closest(rays);
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (hits[i].id != shared::NO_HIT)
      points.push_back(shadowPoint(subject, data.bvh, rays[i], hits[i].id, light));
  EXPECT_EQ(points.size(), rays.size());
  return subject.visible(light, points);
}

LAVER_STABILITY(Acne, "A flat plane lit at grazing angles") {
  std::vector<Setting> settings;
  for (const double scale : {1e-3, 1.0, 1e3, 1e6})
    for (const double light : {1.0, 1e2, 1e4}) settings.push_back({scale, 0.0, 3.0, light});
  // Triangles as large as the scene have the largest rounding errors.
  for (const double light : {1.0, 1e2, 1e4}) settings.push_back({1.0, 0.0, 3.0, light, 1});
  settings.push_back({1.0, 1e3, 3.0, 10.0});
  settings.push_back({1.0, 0.0, 1e3, 10.0});
  settings.push_back({1e3, 1e3, 1e3, 1e3});

  struct Sum {
    std::uint64_t rays = 0, shadows = 0;
    double seconds = 0;
  };
  std::map<std::string, Sum> sums;
  std::vector<std::string> order;
  std::uint64_t naiveRays = 0, naiveCount = 0;
  const auto where = targets(amount(full, kFew, 8 * kFew));
  for (const Setting& setting : settings) {
    const Plane plane(setting);
    const std::size_t few = std::min<std::size_t>(where.size(), kFew);
    naiveRays += few;
    naiveCount += naiveShadows(
        plane, {where.begin(), where.begin() + static_cast<std::ptrdiff_t>(few)}, nullptr);
    const Packed data = pack(plane.scene, {}, uploadsOf(plane.scene, {}));
    for (const auto& subject : subjects(data.bvh)) {
      if (!sums.contains(subject->name)) order.push_back(subject->name);
      Sum& sum = sums[subject->name];
      for (const double elevation : kElevations) {
        const auto seen = sightOf(plane, data, *subject, where, elevation);
        sum.rays += seen.size();
        sum.shadows += static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), 0U));
      }
      sum.seconds += subject->seconds;
    }
  }
  for (const std::string& name : order) {
    const Sum& sum = sums[name];
    const double share = static_cast<double>(naiveCount) / static_cast<double>(naiveRays);
    record.add({"scales 1e-3 to 1e6, lights 1 to 1e4 scales off", name, sum.rays,
                std::round(share * static_cast<double>(sum.rays)), static_cast<double>(sum.shadows),
                0.0, "false shadows", sum.seconds});
  }

  // The plane of the picture has size 1,000, the camera is 3,000 away, the light 1,000.
  Bitmap before(96, 96, {}), after(96, 96, {});
  std::vector<glm::dvec2> grid;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) grid.emplace_back((x - 47.5) / 48.5, (y - 47.5) / 48.5);
  const Plane plane({1e3, 0.0, 3.0, 1.0});
  naiveShadows(plane, grid, &before);
  const Packed data = pack(plane.scene, {}, uploadsOf(plane.scene, {}));
  const auto lane = std::move(subjects(data.bvh).front());
  for (std::size_t e = 0; e < 3; ++e) {
    const auto seen = sightOf(plane, data, *lane, grid, kElevations[e]);
    for (std::size_t i = e; i < grid.size(); i += 3)
      if (seen.at(i) != 0) after.pixels[i] = {255, 255, 255};
  }
  record.picture(
      "Acne: a flat plane of half-width 1,000 that nothing shades, lit from 0.3, 0.03 and 0.003 "
      "radians over it by turns; black points think themselves in shadow.",
      before, after);
}

}  // namespace
}  // namespace laver::test
