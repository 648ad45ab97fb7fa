#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/bsdfs.h"
#include "scene/filters.h"
#include "scene/integrators.h"
#include "scene/samplers.h"
#include "scene/texture.h"

namespace laver {

/// Pinhole camera. Camera space: +x left, +y up, +z forward.
struct Camera {
  glm::dmat4 toWorld{1.0};  ///< camera to world, column vectors
  int width = 1280;         ///< pixels
  int height = 720;         ///< pixels
  double fov = 30.0;        ///< horizontal, degrees
  double nearClip = 1e-4;   ///< plane z = nearClip of camera space
  double farClip = 1e4;
};

/// Isotropic point light: radiance / distance^2 arrives at a surface.
struct PointLight {
  glm::dvec3 position{0.0, 100.0, 0.0};
  glm::dvec3 radiance{1.0};
};

/// In world space; its normal points outwards.
struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 1.0;
};

/// Triangles in world space. Attributes are empty or hold one entry a vertex.
struct Mesh {
  std::string name;              ///< the file name as the scene gives it
  std::optional<Sphere> sphere;  ///< instead of triangles
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  ///< unit length
  std::vector<glm::dvec2> uvs;
  std::vector<glm::uvec3> triangles;   ///< indices into the above, in file order
  std::uint64_t droppedTriangles = 0;  ///< zero-area triangles left out at load
  Bsdf bsdf;

  /// Triangles and spheres, which are numbered together.
  std::size_t primitives() const { return sphere ? 1 : triangles.size(); }
};

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
  if (scene.integrator.row == wanted.row) return scene.integrator;
  return scene.fileIntegrator.row == wanted.row ? scene.fileIntegrator : wanted;
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
