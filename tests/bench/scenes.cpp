#include "bench/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace laver::bench {
namespace {

/// Splits each triangle into four at the midpoints of its edges.
void subdivide(Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(mesh.positions.size());
    const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), next);
    if (isNew) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5);
    return at->second;
  };
  std::vector<glm::uvec3> triangles;
  triangles.reserve(mesh.triangles.size() * 4);
  for (const glm::uvec3 t : mesh.triangles) {
    const glm::uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
    for (const glm::uvec3 part :
         {glm::uvec3(t.x, m.x, m.z), glm::uvec3(m.x, t.y, m.y), glm::uvec3(m.z, m.y, t.z), m})
      triangles.push_back(part);
  }
  mesh.triangles = std::move(triangles);
}

}  // namespace

std::string sceneFile(const std::string& path) {
  return std::string(LAVER_SOURCE_DIR) + "/" + path;
}

std::string titleOf(const std::string& scene, int times) {
  return times == 0 ? scene : fmt::format("{} x{}", scene, 1 << (2 * times));
}

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

Scene benchScene(const std::string& name, int times, const std::string& integrator,
                 std::uint32_t samples) {
  SceneOverrides overrides;
  overrides.integrator = IntegratorUse{rowCalled(integratorRows(), integrator)};
  overrides.sampleCount = samples;
  Scene scene = loadScene(sceneFile("tests/bench/scenes/" + name + ".xml"), overrides).scene;
  for (Mesh& mesh : scene.meshes) {
    mesh.normals.clear();
    mesh.uvs.clear();
    for (int i = 0; i < times; ++i) subdivide(mesh);
  }
  return scene;
}

}  // namespace laver::bench
