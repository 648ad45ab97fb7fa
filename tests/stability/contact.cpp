// The smallest gap below an occluder that still casts its shadow.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/packed.h"
#include "stability/naive.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// A floor, tilted or not, and a smaller plate at `gap` above its middle. Specks in two opposite
/// corners fix the scene's box; the floor is `level` half-widths of the box from its centre.
struct Contact {
  Contact(double theScale, double level, bool tilted, double gap) : scale(theScale) {
    normal = tilted ? glm::normalize(dvec3(0.3, -0.5, 0.8)) : dvec3(0, 0, 1);
    u = tilted ? glm::normalize(glm::cross(normal, dvec3(0.1, 1.0, 0.2))) : dvec3(1, 0, 0);
    v = glm::cross(normal, u);
    origin = level * normal;
    // The camera sees the scene from outside, far enough away that triangles are uploaded as they
    // are, unsplit and centred on their box: an ordinary scene (render/space.h).
    scene.camera.toWorld[3] = glm::dvec4(0.0, 0.0, -6.0 * scale, 1.0);
    scene.meshes = {gridMesh(4, [&](double x, double y) { return at(0.5 * x, 0.5 * y, 0.0); }),
                    gridMesh(4, [&](double x, double y) { return at(0.3 * x, 0.3 * y, gap); })};
    for (const double corner : {-1.0, 1.0}) {
      Mesh speck = gridMesh(1, [&](double x, double y) {
        return scale * corner * dvec3(1.0 - 1e-3 * (1 + x), 1.0 - 1e-3 * (1 + y), 1.0);
      });
      scene.meshes.push_back(speck);
    }
  }
  dvec3 at(double x, double y, double height) const {
    return scale * (origin + x * u + y * v + height * normal);
  }
  double scale;
  dvec3 normal, u, v, origin;
  Scene scene;
};

constexpr int kPoints = 256;
/// Floor points under the plate, visible from below its border.
glm::dvec2 floorPoint(int i) {
  const int column = i % 16, row = i / 16;
  return {0.2 * (column / 7.5 - 1.0) + 1e-3, 0.2 * (row / 7.5 - 1.0) + 2e-3};
}

bool naiveSees(const Contact& c, double light) {
  std::vector<shared::Triangle> triangles = listedTriangles(c.scene.meshes[0]);
  const auto plate = listedTriangles(c.scene.meshes[1]);
  triangles.insert(triangles.end(), plate.begin(), plate.end());
  for (int i = 0; i < kPoints; ++i) {
    const glm::vec3 p(c.at(floorPoint(i).x, floorPoint(i).y, 0.0));
    const glm::vec3 direction = glm::vec3(c.at(0.0, 0.0, light)) - p;
    const float length = glm::length(direction);
    TestHit hit{};
    if (std::none_of(triangles.begin(), triangles.end(), [&](const auto& t) {
          return naive::moellerTrumbore(p, direction / length, t, 1e-4F, length * (1 - 1e-4F), hit);
        }))
      return false;
  }
  return true;
}

/// Floor points found by camera rays that start right above them, below the plate.
bool seesAll(Subject& subject, const Contact& c, const Packed& data, double light) {
  const glm::vec3 lightPosition(data.space.apply(c.at(0.0, 0.0, light)));
  std::vector<glm::vec3> points;
  for (const shared::Triangle& t : data.bvh.triangles) {
    if (t.id >= 32) continue;  // the floor's triangles come first
    for (int i = 0; i < kPoints; ++i) {
      const glm::dvec2 w = floorPoint(i);
      const glm::vec3 eye(data.space.apply(c.at(w.x + 0.3, w.y - 0.2, -0.7)));
      const auto ray = rayOf(eye, glm::vec3(data.space.apply(c.at(w.x, w.y, 0.0)) - dvec3(eye)));
      if (twins()[1]->inside(ray.origin, ray.direction, t))
        points.push_back(shadowPoint(subject, data.bvh, ray, t.id, lightPosition));
    }
  }
  EXPECT_GE(points.size(), static_cast<std::size_t>(kPoints));
  const auto seen = subject.visible(lightPosition, points);
  return std::count(seen.begin(), seen.end(), 0U) == static_cast<std::ptrdiff_t>(seen.size());
}

LAVER_STABILITY(Contact, "The smallest contact gap that still casts a shadow") {
  // The sweep starts with the largest gap and ends where a point under the plate is lit: quarters,
  // then multiples of 2^-24 of the half-width, an ulp at 0.9 of it.
  std::vector<double> gaps;
  for (double gap = 0.2; gap > 2e-6; gap *= 0.25) gaps.push_back(gap);
  for (const int ulps : {16, 12, 8, 6, 4, 3, 2, 1}) gaps.push_back(ulps * 0x1p-24);
  struct Place {
    const char* name;
    double level;
    bool tilted;
    double wanted;
  };
  // Floats of 0.5 to 1 are 2^-24 apart: 8 ulp are 4.8e-7 of the half-width.
  for (const Place place : {Place{"tilted floor at the origin", 0.0, true, 1e-5},
                            Place{"flat floor at 0.9 of the half-width", 0.9, false, 8 * 0x1p-24}})
    for (const auto& [scale, light] :
         {std::pair(1e-3, 1.0), std::pair(1.0, 1.0), std::pair(1e3, 1.0), std::pair(1.0, 1e2),
          std::pair(1.0, 1e4)}) {
      // At 1e3 Nori's mint is small enough, but then its plane shadows itself (Acne).
      double naiveGap = 1.0;
      std::map<std::string, double> smallest;
      std::vector<std::string> order;
      for (const double g : gaps) {
        const Contact c(scale, place.level, place.tilted, g);
        if (naiveGap > 0 && naiveSees(c, light))
          naiveGap = g;
        else
          naiveGap = -std::abs(naiveGap);
        const Packed data = pack(c.scene, {}, uploadsOf(c.scene, {}));
        for (const auto& subject : subjects(data.bvh)) {
          if (!smallest.contains(subject->name)) order.push_back(subject->name);
          double& gap = smallest.try_emplace(subject->name, 1.0).first->second;
          if (gap > 0) gap = seesAll(*subject, c, data, light) ? g : -gap;
        }
      }
      for (const std::string& name : order)
        record.add({fmt::format("{}, scale {:.0e}, light {:.0e}", place.name, scale, light), name,
                    kPoints * gaps.size(),
                    scale > 1.0 ? std::nullopt : std::optional(std::abs(naiveGap)),
                    std::abs(smallest[name]), place.wanted, "of the scale"});
    }
}

}  // namespace
}  // namespace laver::test
