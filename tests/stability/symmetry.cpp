// A scene that is mirrored, has its axes permuted, or is moved keeps its hits: the same triangle at
// points well inside, and the same distance up to some ulp.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "pictures/harness.h"
#include "render/packed.h"
#include "stability/exact.h"
#include "stability/meshes.h"
#include "stability/record.h"
#include "stability/statistics.h"
#include "stability/subject.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// Rays to points well inside triangles of a sphere of half-width about 1, in scene space.
struct Rays {
  std::vector<dvec3> origins, targets;
};

Rays raysAt(const Mesh& mesh, std::uint64_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.1, 0.8), place(-0.2, 0.2);
  Rays rays;
  dvec3 origin(0.0);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % 64 == 0) origin = {place(random), place(random), place(random)};
    const glm::uvec3 t = mesh.triangles[random() % mesh.triangles.size()];
    double u = unit(random), v = (0.9 - u) * unit(random) + 0.02;
    rays.origins.push_back(origin);
    rays.targets.push_back(mesh.positions[t.x] * (1 - u - v) + mesh.positions[t.y] * u +
                           mesh.positions[t.z] * v);
  }
  return rays;
}

LAVER_STABILITY(Symmetry, "Mirrored, axes permuted, translated") {
  const Mesh sphere = bumpySphere(60, 80, 0.02, dvec3(0.0));
  const Rays rays = raysAt(sphere, amount(full, 1ULL << 16, 1ULL << 19));
  struct Change {
    const char* name;
    std::function<dvec3(dvec3)> apply;
  };
  const std::vector<Change> changes = {
      {"as it is", [](dvec3 p) { return p; }},
      {"mirrored in x", [](dvec3 p) { return dvec3(-p.x, p.y, p.z); }},
      {"turned by half", [](dvec3 p) { return dvec3(-p.x, -p.y, p.z); }},
      {"axes yzx", [](dvec3 p) { return dvec3(p.y, p.z, p.x); }},
      {"axes yxz", [](dvec3 p) { return dvec3(p.y, p.x, p.z); }},
      {"moved by 1,000", [](dvec3 p) { return p + dvec3(1000.0, -700.0, 300.0); }}};
  std::map<std::string, std::vector<TestHit>> first;
  for (const Change& change : changes) {
    Scene scene;
    scene.meshes = {sphere};
    for (dvec3& p : scene.meshes[0].positions) p = change.apply(p);
    const Packed data = pack(scene, {}, uploadsOf(scene, {}));
    std::vector<test::TestRay> moved;
    for (std::size_t i = 0; i < rays.origins.size(); ++i) {
      const glm::vec3 origin(data.space.apply(change.apply(rays.origins[i])));
      moved.push_back(rayOf(
          origin, glm::vec3(data.space.apply(change.apply(rays.targets[i])) - dvec3(origin))));
    }
    for (const auto& subject : subjects(data.bvh)) {
      const auto hits = subject->closest(moved);
      auto& original = first[subject->name];
      if (original.empty()) {
        original = hits;
        continue;
      }
      std::vector<double> errors;
      std::uint64_t otherIds = 0;
      for (std::size_t i = 0; i < hits.size(); ++i) {
        otherIds += hits[i].id == original[i].id ? 0 : 1;
        errors.push_back(ulps(hits[i].t, static_cast<double>(original[i].t)));
      }
      record.add({std::string(change.name) + ", other triangles", subject->name, hits.size(),
                  std::nullopt, static_cast<double>(otherIds), 0.0, "rays"});
      record.add({std::string(change.name) + ", p99 of t", subject->name, hits.size(), std::nullopt,
                  percentile(errors, 0.99), 4.0, "ulp"});
    }
  }
}

}  // namespace
}  // namespace laver::test
