#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/cameras.h"
#include "scene/dialects.h"
#include "scene/emitters.h"
#include "scene/filters.h"
#include "scene/integrators.h"
#include "scene/meshes.h"
#include "scene/samplers.h"

namespace laver {

/// A scene as plain data: no Vulkan, no file handles.
struct Scene {
  std::string file;  ///< path it was read from
  IntegratorUse integrator;
  /// What the file names, if another one is shown. Where it is shown beside that, its properties
  /// hold.
  IntegratorUse fileIntegrator;
  Camera camera;
  Filter filter;
  Sampler sampler;
  std::vector<Mesh> meshes;
  std::vector<PointLight> lights;
  std::optional<Environment> environment;
};

/// An integrator with the properties that the scene's file gives it.
inline IntegratorUse useOf(const Scene& scene, const IntegratorUse& wanted) {
  if (!wanted.values.empty()) return wanted;
  if (scene.integrator == wanted) return scene.integrator;
  return scene.fileIntegrator == wanted ? scene.fileIntegrator : wanted;
}

inline bool hasSpheres(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                     [](const Mesh& mesh) { return mesh.sphere.has_value(); });
}

/// Of all meshes.
inline std::uint64_t primitivesOf(const Scene& scene) {
  std::uint64_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.primitives();
  return count;
}

/// What the command line changes in a scene before it is checked.
struct SceneOverrides {
  std::optional<IntegratorUse> integrator;
  const SamplerRow* sampler = nullptr;
  std::optional<std::uint32_t> sampleCount;
  std::optional<std::int64_t> seed;
  std::optional<glm::ivec2> size;     ///< width, height in pixels
  bool shading = false;               ///< materials and lights are needed, whatever the integrator
  const Dialect* dialect = dialects().front();
  bool noriCompat = false;            ///< textures of 8 and 16 bits are taken for linear
  const FilterRow* filter = nullptr;  ///< with the scene's parameters where it has that filter
};

/// A scene and what its reader should be told: one `file:line:col: warning: ...` line each.
struct LoadedScene {
  Scene scene;
  std::vector<std::string> warnings;
};

/// Reads a Nori XML scene, its meshes and, where the integrator needs them, its pictures. Throws
/// Error(ExitCode::Scene) whose text holds one `file:line:col: error: ...` line for every error
/// found.
LoadedScene loadScene(const std::string& file, const SceneOverrides& overrides = {});

/// The `Scene[ ... ]` text that Nori prints.
std::string describe(const Scene& scene);

}  // namespace laver
