#include "render/scene_data.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>

#include "render/camera_data.h"
#include "render/sampler_data.h"
#include "render/texture_data.h"
#include "render/traversal.h"

namespace laver {
namespace {

using glm::dvec3;
using glm::vec3;

/// Largest e with 2^e <= x, for finite x > 0.
int floorLog2(double x) { return std::ilogb(x); }

/// Packs the meshes' triangles in file order; attributes get one entry a triangle.
class MeshPacker {
 public:
  MeshPacker(const Scene& scene, SceneData& data, TexturePacker& textures)
      : scene_(scene), data_(data), textures_(textures) {}

  std::vector<shared::Triangle> pack() {
    if (data_.constants[shared::SPEC_HITS] == 0) return {};
    if (hasNormals_) data_.normals.emplace_back(0.0F);  // NO_NORMAL's place
    for (const Mesh& mesh : scene_.meshes) add(mesh);
    return std::move(triangles_);
  }

 private:
  /// Returns its number.
  std::uint32_t addMaterial(const Mesh& mesh) {
    if (hasTextures_) {
      textures_.addMaterial(mesh, nextId_);
      return static_cast<std::uint32_t>(data_.textures.size() - 1);
    }
    if (!hasAlbedos_) return 0;
    data_.materials.push_back({vec3(mesh.bsdf.albedo), 0.0F});
    return static_cast<std::uint32_t>(data_.materials.size() - 1);
  }

  void addSphere(const Mesh& mesh) {
    const std::uint32_t material = addMaterial(mesh);
    const std::uint32_t id = nextId_++;
    // Like a triangle without coordinates: the kernels take u and v for weights (ball.glsl).
    if (hasTextures_) textures_.addTriangle(mesh, {0, 1, 2}, {0, 1, 2});
    const auto radius = static_cast<float>(mesh.sphere->radius * data_.space.scale);
    // sphere.h takes these to unit size by a power of two that floats hold.
    if (radius < 0x1p-100F) {
      ++data_.collapsedTriangles;
      return;
    }
    triangles_.push_back({vec3(data_.space.apply(mesh.sphere->centre)), id, vec3(radius), 0,
                          vec3(0.0F), shared::IS_SPHERE});
    if (hasNormals_ || hasAlbedos_)
      data_.attributes.push_back(
          {material, shared::NO_NORMAL, shared::NO_NORMAL, shared::NO_NORMAL});
  }

  void add(const Mesh& mesh) {
    if (mesh.sphere) return addSphere(mesh);
    std::vector<vec3> positions(mesh.positions.size());
    std::transform(mesh.positions.begin(), mesh.positions.end(), positions.begin(),
                   [&](const dvec3& p) { return vec3(data_.space.apply(p)); });
    const bool smooth = hasNormals_ && !mesh.normals.empty();
    const auto firstNormal = static_cast<std::uint32_t>(data_.normals.size());
    if (smooth)
      for (const dvec3& n : mesh.normals) data_.normals.emplace_back(vec3(n), 0.0F);
    const std::uint32_t material = addMaterial(mesh);
    for (const glm::uvec3 given : mesh.triangles) {
      glm::uvec3 t = given;
      const std::uint32_t flipped = sortCorners(t, positions) ? 1 : 0;
      const vec3 a = positions[t.x], b = positions[t.y], c = positions[t.z];
      const std::uint32_t id = nextId_++;
      if (hasTextures_) textures_.addTriangle(mesh, given, t);
      // An edge of no length has no inside; its neighbours still meet. Triangles that merely
      // became collinear stay: they fill what rounding opens beside them.
      if (a == b || b == c || c == a) {
        ++data_.collapsedTriangles;
        continue;
      }
      triangles_.push_back({a, id, b, 0, c, flipped});
      if (!hasNormals_ && !hasAlbedos_) continue;
      const glm::uvec3 n = smooth ? t + firstNormal : glm::uvec3(shared::NO_NORMAL);
      data_.attributes.push_back({material, n.x, n.y, n.z});
    }
  }

  /// Orders corners by position; true if that turned the winding.
  static bool sortCorners(glm::uvec3& t, const std::vector<vec3>& positions) {
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
      const vec3 p = positions[i], q = positions[j];
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    bool turned = false;
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)})
      if (before(t[j], t[i])) {
        std::swap(t[i], t[j]);
        turned = !turned;
      }
    return turned;
  }

  const Scene& scene_;
  SceneData& data_;
  TexturePacker& textures_;
  std::vector<shared::Triangle> triangles_;
  std::uint32_t nextId_ = 0;
  bool hasNormals_ = data_.constants[shared::SPEC_NORMALS] != 0;
  bool hasAlbedos_ = data_.constants[shared::SPEC_ALBEDOS] != 0;
  bool hasTextures_ = data_.constants[shared::SPEC_TEXTURES] != 0;
};

/// Attributes are gathered by triangle in file order; leaves want them in their own.
void sortAttributes(SceneData& data, const std::vector<shared::Triangle>& inFileOrder) {
  if (data.attributes.empty()) return;
  std::vector<std::uint32_t> placeOf(inFileOrder.back().id + 1);
  for (std::uint32_t i = 0; i < inFileOrder.size(); ++i) placeOf[inFileOrder[i].id] = i;
  std::vector<shared::Attributes> sorted(data.attributes.size());
  for (std::size_t slot = 0; slot < sorted.size(); ++slot)
    sorted[slot] = data.attributes[placeOf[data.bvh.triangles[slot].id]];
  data.attributes = std::move(sorted);
}

/// How far av looks. Points of the scene lie in [-1, 1]^3, less than 4 apart; below 2^-100 nothing
/// is seen apart.
float reachOf(const Scene& scene, const Normalisation& space) {
  const double length = useOf(scene, {&integrators::averageVisibility}).real("length");
  return static_cast<float>(std::clamp(length * space.scale, 0x1p-100, 4.0));
}

/// radiance / distance^2 keeps its value when distances are scaled, if radiance is by the square.
shared::Light lightData(const PointLight& light, const Normalisation& space) {
  return {vec3(space.apply(light.position)), 0.0F,
          vec3(light.radiance * (space.scale * space.scale)), 0.0F};
}

}  // namespace

Normalisation normalisationOf(const Scene& scene) {
  dvec3 lo(std::numeric_limits<double>::infinity()), hi(-lo);
  for (const Mesh& mesh : scene.meshes) {
    if (mesh.sphere) {
      lo = glm::min(lo, mesh.sphere->centre - mesh.sphere->radius);
      hi = glm::max(hi, mesh.sphere->centre + mesh.sphere->radius);
    }
    for (const glm::uvec3& t : mesh.triangles)
      for (int corner = 0; corner < 3; ++corner) {
        lo = glm::min(lo, mesh.positions[t[corner]]);
        hi = glm::max(hi, mesh.positions[t[corner]]);
      }
  }
  if (lo.x > hi.x) return {};
  Normalisation space;
  space.centre = lo * 0.5 + hi * 0.5;
  const dvec3 half = hi * 0.5 - lo * 0.5;
  const double largest = std::max({half.x, half.y, half.z});
  // Half-width in (1/2, 1) for any scene of a representable size.
  if (largest > 0.0)
    space.scale = std::ldexp(1.0, std::clamp(-1 - floorLog2(largest), -1000, 1000));
  return space;
}

SceneData packScene(const Scene& scene, const RenderOptions& options,
                    const SpecConstants& constants) {
  SceneData data;
  data.constants = constants;
  data.space = normalisationOf(scene);
  TexturePacker textures(data);
  const auto triangles = MeshPacker(scene, data, textures).pack();
  data.triangles = triangles.size();
  const auto start = std::chrono::steady_clock::now();
  data.bvh = buildBvh(triangles, options.threads);
  data.buildSeconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  sortAttributes(data, triangles);
  if (constants[shared::SPEC_LIGHTS] != shared::LIGHTS_NONE)
    for (const PointLight& light : scene.lights)
      data.lights.push_back(lightData(light, data.space));

  requireStack(data.constants, data.bvh.stack);
  packCamera(scene, data);
  packFilter(scene.filter, data);
  packSampler(scene, data);
  if (scene.environment && constants[shared::SPEC_BACKGROUND] != shared::BACKGROUND_BLACK)
    textures.packBackground(*scene.environment);
  if (!scene.meshes.empty())
    data.params.albedo = glm::vec4(vec3(scene.meshes.front().bsdf.albedo), 0.0F);
  data.params.film.w = data.bvh.root;
  data.params.clip.w = reachOf(scene, data.space);
  data.params.origin.w = packetWindow(primitivesOf(scene));
  return data;
}

}  // namespace laver
