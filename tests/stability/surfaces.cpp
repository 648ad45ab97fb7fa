#include "stability/surfaces.h"

namespace laver::test {

Mesh gridMesh(int cells, const std::function<glm::dvec3(double, double)>& place) {
  Mesh mesh;
  const auto side = static_cast<std::uint32_t>(cells) + 1;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      mesh.positions.push_back(place(2.0 * x / cells - 1.0, 2.0 * y / cells - 1.0));
  for (std::uint32_t y = 0; y + 1 < side; ++y)
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t i = y * side + x;
      mesh.triangles.emplace_back(i, i + 1, i + side + 1);
      mesh.triangles.emplace_back(i, i + side + 1, i + side);
    }
  return mesh;
}

std::vector<shared::Triangle> listedTriangles(const Mesh& mesh) {
  std::vector<shared::Triangle> triangles;
  for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
    const glm::uvec3 t = mesh.triangles[id];
    triangles.push_back({glm::vec3(mesh.positions[t.x]), id, glm::vec3(mesh.positions[t.y]), 0,
                         glm::vec3(mesh.positions[t.z]), 0});
  }
  return triangles;
}

glm::vec3 shadowPoint(const Subject& subject, const Bvh& bvh, const TestRay& ray, std::uint32_t id,
                      glm::vec3 light) {
  static const Twin* const optimised = twins()[1];
  const Twin* twin = subject.twin != nullptr ? subject.twin : optimised;
  std::size_t slot = 0;
  while (bvh.triangles[slot].id != id) ++slot;  // scenes of these cases have few
  const shared::Point p = twin->point(ray.origin, ray.direction, bvh.triangles[slot]);
  const float side =
      shared::dotProduct(p.geometric, light - p.position) < 0.0F ? -p.offset : p.offset;
  return p.position + p.geometric * side;
}

}  // namespace laver::test
