// Rays along an axis, in the planes of the tree's boxes, from points on faces and vertices. In a
// closed cube of axis-parallel facets each of them must hit a wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "lab/chart/methods/quantise.h"
#include "stability/meshes.h"
#include "stability/naive.h"
#include "stability/record.h"
#include "stability/subject.h"

namespace laver::test {
namespace {

constexpr int kCells = 64;  // facets' corners lie on multiples of 1/64, which floats hold

ClosedMesh cube() {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [at, isNew] = known.try_emplace(p, static_cast<std::uint32_t>(positions.size()));
    if (isNew)
      positions.emplace_back(glm::vec3(p[0], p[1], p[2]) / (static_cast<float>(kCells) / 2.0F) -
                             1.0F);
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, kCells})
      for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j) {
          const auto at = [&](int di, int dj) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            return vertex(p);
          };
          triangles.emplace_back(at(0, 0), at(1, 0), at(1, 1));
          triangles.emplace_back(at(0, 0), at(1, 1), at(0, 1));
        }
  return closedMesh(std::move(positions), std::move(triangles));
}

/// A point in or on the cube, with coordinates on the facets' grid or between; directions along an
/// axis have zeros of both signs.
glm::vec3 gridPoint(std::mt19937& random) {
  glm::vec3 p;
  for (int a = 0; a < 3; ++a) {
    const auto steps = static_cast<float>(random() % (2 * kCells + 1));
    p[a] = steps / static_cast<float>(kCells) - 1.0F;
  }
  return p;
}
glm::vec3 axisDirection(std::mt19937& random) {
  const auto bits = static_cast<std::uint32_t>(random());
  glm::vec3 d((bits & 1U) != 0 ? 0.0F : -0.0F, (bits & 2U) != 0 ? 0.0F : -0.0F,
              (bits & 4U) != 0 ? 0.0F : -0.0F);
  d[static_cast<int>(bits >> 4 & 0xFFFFU) % 3] = (bits & 8U) != 0 ? 1.0F : -1.0F;
  return d;
}

LAVER_STABILITY(AxisParallel, "Axis-parallel rays, origin on a face, through the BVH") {
  const ClosedMesh mesh = cube();
  const Bvh tight = chart::withTightBoxes(mesh.bvh);
  std::vector<TestRay> rays(amount(full, 1ULL << 18, 1ULL << 21) / 64 * 64);
  std::mt19937 random(1);
  glm::vec3 origin(0.0F);
  std::uint64_t naiveMisses = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (i % 64 == 0) origin = gridPoint(random);
    rays[i] = rayOf(origin, axisDirection(random));
    const bool met =
        naive::intersects(tight, rays[i].origin, rays[i].direction, naive::Method::Slabs);
    naiveMisses += met ? 0 : 1;
  }
  for (const auto& subject : subjects(mesh.bvh)) {
    const auto hits = subject->closest(rays);
    const auto misses = std::count_if(hits.begin(), hits.end(),
                                      [](const auto& h) { return h.id == shared::NO_HIT; });
    record.add({"cube of 49,152 facets", subject->name, rays.size(),
                static_cast<double>(naiveMisses), static_cast<double>(misses), 0.0, "misses",
                subject->seconds});
  }
}

}  // namespace
}  // namespace laver::test
