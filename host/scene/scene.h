#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scene/texture.h"

namespace laver {

/// What a pixel shows. The last two are layers, which no scene names: the shading normal with its
/// signs, and the albedo.
enum class Integrator {
  Normals,
  DirectWhitted,
  Depth,
  AverageVisibility,
  AmbientOcclusion,
  ShadingNormal,
  Albedo
};

/// Pinhole camera. Camera space: +x left, +y up, +z forward.
struct Camera {
  glm::dmat4 toWorld{1.0};  ///< camera to world, column vectors
  int width = 1280;         ///< pixels
  int height = 720;         ///< pixels
  double fov = 30.0;        ///< horizontal, degrees
  double nearClip = 1e-4;   ///< plane z = nearClip of camera space
  double farClip = 1e4;
};

/// Reconstruction filter, separable; radius and stddev in pixels.
struct Filter {
  enum class Kind { Gaussian, Mitchell, Tent, Box };
  Kind kind = Kind::Gaussian;
  double radius = 2.0;
  double stddev = 0.5;   ///< gaussian only
  double B = 1.0 / 3.0;  ///< Mitchell only
  double C = 1.0 / 3.0;  ///< Mitchell only
};

/// Where the samples of a pixel lie.
struct Sampler {
  enum class Kind {
    Independent,  ///< Nori's: uniform, each by itself
    Stratified,   ///< uniform, one in each of strataOf(sampleCount)
    Sobol         ///< a (0,2)-sequence, Owen-scrambled by pixel; the count changes no sample
  };
  std::uint32_t sampleCount = 1;  ///< per pixel
  std::int64_t seed = 0;
  Kind kind = Kind::Independent;
};

/// Lambertian reflection.
struct Diffuse {
  glm::dvec3 albedo{0.5};
  std::optional<Texture> texture;  ///< stands for the albedo
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
  Diffuse bsdf;

  /// Triangles and spheres, which are numbered together.
  std::size_t primitives() const { return sphere ? 1 : triangles.size(); }
};

/// A scene as plain data: no Vulkan, no file handles.
struct Scene {
  std::string file;  ///< path it was read from
  Integrator integrator = Integrator::Normals;
  /// How far `av` looks, in scene units.
  double avLength = std::numeric_limits<double>::infinity();
  Camera camera;
  Filter filter;
  Sampler sampler;
  std::vector<Mesh> meshes;
  std::vector<PointLight> lights;
  std::optional<Environment> environment;
};

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
  std::optional<Integrator> integrator;
  std::optional<Sampler::Kind> sampler;
  std::optional<std::uint32_t> sampleCount;
  std::optional<std::int64_t> seed;
  std::optional<glm::ivec2> size;      ///< width, height in pixels
  bool shading = false;                ///< materials and lights are needed, whatever the integrator
  bool noriCompat = false;             ///< textures of 8 and 16 bits are taken for linear
  std::optional<Filter::Kind> filter;  ///< with the scene's parameters where it has that kind
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

/// Nori's name of an integrator, as in the XML.
const char* integratorName(Integrator integrator);

/// The integrator of that name, if laver has it.
std::optional<Integrator> integratorFromName(const std::string& name);

/// Nori's name of a filter, as in the XML.
const char* filterName(Filter::Kind kind);

/// The filter of that name with the parameters that the XML may leave out, if laver has it.
std::optional<Filter> filterFromName(const std::string& name);

/// The same of a sampler.
const char* samplerName(Sampler::Kind kind);
std::optional<Sampler::Kind> samplerFromName(const std::string& name);

/// Columns and rows of strata of the sampler `stratified`: the factors of the count that are
/// nearest to each other, the smaller first.
glm::uvec2 strataOf(std::uint32_t sampleCount);

/// The `Scene[ ... ]` text that Nori prints.
std::string describe(const Scene& scene);

}  // namespace laver
