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
  /// The integrator of the file, if another one is rendered; its properties apply if it is rendered
  /// as a layer.
  IntegratorUse fileIntegrator;
  Camera camera;
  Filter filter;
  Sampler sampler;
  std::vector<Mesh> meshes;
  std::vector<PointLight> lights;
  std::optional<Environment> environment;
};

/// An integrator with the properties that the scene's file sets.
inline IntegratorUse useOf(const Scene& scene, const IntegratorUse& wanted) {
  if (!wanted.values.empty()) return wanted;
  if (scene.integrator == wanted) return scene.integrator;
  return scene.fileIntegrator == wanted ? scene.fileIntegrator : wanted;
}

inline bool hasSpheres(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                     [](const Mesh& mesh) { return mesh.sphere.has_value(); });
}

/// Number of primitives of all meshes.
inline std::uint64_t primitivesOf(const Scene& scene) {
  std::uint64_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.primitives();
  return count;
}

/// Changes to a scene by the command line, before it is checked.
struct SceneOverrides {
  std::optional<IntegratorUse> integrator;
  const SamplerRow* sampler = nullptr;
  std::optional<std::uint32_t> sampleCount;
  std::optional<std::int64_t> seed;
  std::optional<glm::ivec2> size;  ///< width, height in pixels
  bool shading = false;  ///< materials and lights are needed even if the integrator ignores them
  const Dialect* dialect = dialects().front();
  bool dialectNamed = false;          ///< otherwise a scene of another family causes a hint
  bool noriCompat = false;            ///< textures of 8 and 16 bits are read as linear
  const FilterRow* filter = nullptr;  ///< keeps the scene's parameters if it has that filter
};

/// A scene and the warnings about it: one `file:line:col: warning: ...` line each.
struct LoadedScene {
  Scene scene;
  std::vector<std::string> warnings;
};

/// Reads a Nori XML scene, its meshes and, if the integrator needs them, its images. Throws
/// Error(ExitCode::Scene) with one `file:line:col: error: ...` line for every error found.
LoadedScene loadScene(const std::string& file, const SceneOverrides& overrides = {});

/// The `Scene[ ... ]` text that Nori prints.
std::string describe(const Scene& scene);

}  // namespace laver
