#include "random/shrink.h"

#include <algorithm>

namespace laver::test {
namespace {

using Fails = std::function<bool(const RandomScene&)>;

/// Keeps a change under which the scene still fails.
template <class Change>
bool keep(RandomScene& random, const Fails& fails, const Change& change) {
  RandomScene changed = random;
  change(changed);
  if (!fails(changed)) return false;
  random = std::move(changed);
  return true;
}

/// Leaves out portions of a list, from halves to single elements.
template <class List>
bool thin(RandomScene& random, const Fails& fails, const List& list, std::size_t least) {
  bool any = false;
  for (std::size_t portion = std::max<std::size_t>(list(random.scene).size() / 2, 1);;
       portion /= 2) {
    for (std::size_t at = 0; at < list(random.scene).size();) {
      const std::size_t size = list(random.scene).size();
      const std::size_t end = std::min(at + portion, size);
      const bool left =
          size - (end - at) >= least && keep(random, fails, [&](RandomScene& r) {
            auto& of = list(r.scene);
            using Offset = std::ptrdiff_t;
            of.erase(of.begin() + static_cast<Offset>(at), of.begin() + static_cast<Offset>(end));
          });
      any |= left;
      if (!left) at = end;
    }
    if (portion == 1) return any;
  }
}

void simplifyMeshes(RandomScene& random, const Fails& fails) {
  for (std::size_t i = 0; i < random.scene.meshes.size(); ++i) {
    const auto change = [&](const auto& of) {
      keep(random, fails, [&](RandomScene& r) { of(r.scene.meshes[i]); });
    };
    change([](Mesh& mesh) { mesh.normals.clear(); });
    change([](Mesh& mesh) { mesh.uvs.clear(); });
    change([](Mesh& mesh) { mesh.light.reset(); });
    change([](Mesh& mesh) { mesh.bsdf = {}; });
    change([](Mesh& mesh) { mesh.bsdf.textures.clear(); });
    if (!random.scene.meshes[i].sphere)
      thin(
          random, fails,
          [i](Scene& scene) -> std::vector<glm::uvec3>& { return scene.meshes[i].triangles; }, 0);
  }
}

void simplifyRest(RandomScene& random, const Fails& fails) {
  const auto change = [&](const auto& of) {
    keep(random, fails, [&](RandomScene& r) { of(r.scene); });
  };
  change([](Scene& scene) { scene.environment.reset(); });
  change([](Scene& scene) { scene.integrator.values.clear(); });
  change([](Scene& scene) { scene.filter = filterOf(filters::box); });
  change([](Scene& scene) { scene.sampler.sampleCount = 1; });
  change([](Scene& scene) { scene.sampler.row = &samplers::independent; });
  change([](Scene& scene) { scene.camera.row = &cameras::perspective; });
  for (std::size_t i = 0; i < random.scene.lights.size(); ++i) {
    change([i](Scene& scene) { scene.lights[i].row = &emitters::point; });
    change([i](Scene& scene) { scene.lights[i].radiance = glm::dvec3(1.0); });
  }
}

}  // namespace

RandomScene shrunk(RandomScene random, const Fails& fails) {
  const auto meshes = [](Scene& scene) -> std::vector<Mesh>& { return scene.meshes; };
  const auto lights = [](Scene& scene) -> std::vector<PointLight>& { return scene.lights; };
  bool smaller = true;
  while (smaller) {
    smaller = thin(random, fails, meshes, 1);
    if (thin(random, fails, lights, 0)) smaller = true;
    simplifyRest(random, fails);
    simplifyMeshes(random, fails);
  }
  return random;
}

}  // namespace laver::test
