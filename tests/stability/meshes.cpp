#include "stability/meshes.h"

#include <functional>
#include <tuple>

#include "core/parallel.h"
#include "pictures/harness.h"
#include "support/bumpy_sphere.h"

namespace laver::test {

ClosedMesh closedMesh(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
  ClosedMesh mesh{std::move(positions), std::move(triangles), {}};
  std::vector<shared::Triangle> packed;
  for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
    std::array<glm::vec3, 3> c;
    for (int i = 0; i < 3; ++i)
      c[static_cast<std::size_t>(i)] = mesh.positions[mesh.triangles[id][i]];
    std::uint32_t flipped = 0;
    const auto before = [](glm::vec3 p, glm::vec3 q) {
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    for (const std::size_t i : {0U, 1U, 0U})
      if (before(c[i + 1], c[i])) {
        std::swap(c[i], c[i + 1]);
        flipped ^= 1U;
      }
    if (c[0] == c[1] || c[1] == c[2]) continue;
    packed.push_back({c[0], id, c[1], 0, c[2], flipped});
  }
  mesh.bvh = buildBvh(packed);
  return mesh;
}

Bvh inListedOrder(const ClosedMesh& mesh) {
  Bvh bvh = mesh.bvh;
  for (shared::Triangle& t : bvh.triangles) {
    const glm::uvec3& corners = mesh.triangles[t.id];
    t.a = mesh.positions[corners.x];
    t.b = mesh.positions[corners.y];
    t.c = mesh.positions[corners.z];
    t.flipped = 0;
  }
  return bvh;
}

ClosedMesh closedBumpySphere(double radius, glm::dvec3 centre) {
  const Mesh sphere = bumpySphere(200, 205, 0.02, glm::dvec3(0.0));
  std::vector<glm::vec3> positions;
  for (const glm::dvec3& p : sphere.positions) positions.emplace_back(centre + radius * p);
  return closedMesh(std::move(positions), sphere.triangles);
}

glm::vec3 aimedRay(const ClosedMesh& mesh, glm::vec3 origin, bool vertex, std::mt19937& random) {
  const glm::uvec3 t = mesh.triangles[random() % mesh.triangles.size()];
  const int corner = static_cast<int>(random() % 3);
  const glm::dvec3 a(mesh.positions[t[corner]]), b(mesh.positions[t[(corner + 1) % 3]]);
  const double along = vertex ? 0.0 : std::uniform_real_distribution<double>()(random);
  return {a + along * (b - a) - glm::dvec3(origin)};
}

void forBatches(std::uint64_t count, std::uint64_t batch, std::uint64_t seed,
                const std::function<void(std::uint64_t, std::mt19937&)>& body) {
  parallelFor((count + batch - 1) / batch, 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::seed_seq words{seed, std::uint64_t{i}};
      std::mt19937 random(words);
      body(i * batch, random);
    }
  });
}

}  // namespace laver::test
