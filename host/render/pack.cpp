#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/error.h"
#include "render/materials.h"
#include "render/pack_parts.h"
#include "render/pack_textures.h"
#include "render/packed.h"
#include "render/traversal.h"

namespace laver {
namespace {

using glm::dvec3;
using glm::vec3;

/// Packs the primitives of the meshes in file order, with one attribute entry each.
class MeshPacker {
 public:
  MeshPacker(const Scene& scene, const Uploads& uploads, Packed& packed, TexturePacker& textures)
      : scene_(scene), uploads_(uploads), packed_(packed), textures_(textures) {}

  std::vector<shared::Triangle> pack() {
    if (!uploads_.primitives) return {};
    if (uploads_.normals) packed_.normals.emplace_back(0.0F);  // the entry of NO_NORMAL
    for (const Mesh& mesh : scene_.meshes) add(mesh);
    return std::move(triangles_);
  }

  /// Those that stand outside of the tree, and their attributes.
  const std::vector<shared::Triangle>& caps() const { return caps_; }
  const std::vector<shared::Attributes>& capAttributes() const { return capAttributes_; }
  /// Triangles of light sources whose meshes were split: light sampling draws from the whole ones.
  const std::vector<shared::Triangle>& wholes() const { return wholes_; }
  const std::vector<shared::Attributes>& wholeAttributes() const { return wholeAttributes_; }

  /// In file order, without the primitives that collapsed.
  const std::vector<shared::Attributes>& attributes() const { return attributes_; }

 private:
  /// Adds the records of the mesh and returns their index.
  std::uint32_t addMaterial(const Mesh& mesh) {
    if (uploads_.textures) textures_.beginMesh(mesh, nextId_);
    if (uploads_.materials) {
      const auto record = recordOf(
          mesh.bsdf, uploads_.layout, uploads_.bsdfs,
          [&](const Texture& texture) { return textures_.addRecord(texture); }, textures_.uvs());
      packed_.materials.insert(packed_.materials.end(), record.begin(), record.end());
    }
    if (uploads_.emission) packed_.emission.push_back(emissionOf(mesh));
    return meshes_++;
  }

  /// Without its radiance.
  shared::Emission emissionOf(const Mesh& mesh) {
    const Texture* texture = mesh.light ? mesh.light->texture.get() : nullptr;
    shared::Emission emission{};
    emission.shown = shared::TEXTURE_NONE;
    if (texture == nullptr || !shows(*texture)) return emission;
    if (packed_.isSplit(meshes_))
      throw Error(
          ExitCode::Device,
          fmt::format("a texture on the radiance of \"{}\", which is cut at its distance from the "
                      "centre of the scene: the radiance of such a mesh can be a colour only",
                      mesh.name));
    emission.shown = textures_.addRecord(*texture) + 1;
    return emission;
  }

  void addSphere(const Mesh& mesh) {
    const std::uint32_t material = addMaterial(mesh);
    const std::uint32_t id = nextId_++;
    // As for a triangle without coordinates, the kernels use u and v as weights (sphere.h).
    if (uploads_.textures) textures_.addTriangle(mesh, {0, 1, 2}, {0, 1, 2});
    if (isCap(*mesh.sphere, packed_.space)) return addCap(*mesh.sphere, id, material);
    const auto radius = static_cast<float>(mesh.sphere->radius * packed_.space.scale);
    // Radii below 2^-100 are out of the range of scaleToUnit() in sphere.h.
    if (radius < 0x1p-100F) {
      ++packed_.collapsedTriangles;
      return;
    }
    triangles_.push_back({vec3(packed_.space.apply(mesh.sphere->centre)), id, vec3(radius), 0,
                          vec3(0.0F), shared::IS_SPHERE});
    attributes_.push_back({material, shared::NO_NORMAL, shared::NO_NORMAL, shared::NO_NORMAL});
  }

  /// (r - d) along the direction from the centre, of length d: no large numbers are subtracted but
  /// these two.
  void addCap(const Sphere& sphere, std::uint32_t id, std::uint32_t material) {
    const Normalisation& space = packed_.space;
    const dvec3 fromCentre = space.centre - sphere.centre;
    const double distance = glm::length(fromCentre);
    const dvec3 normal = distance > 0.0 ? fromCentre / distance : dvec3(0.0, 0.0, 1.0);
    const dvec3 nearest = normal * ((sphere.radius - distance) * space.scale);
    caps_.push_back({vec3(nearest), id, vec3(normal), 0,
                     vec3(static_cast<float>(1.0 / (sphere.radius * space.scale)), 0.0F, 0.0F),
                     shared::IS_CAP});
    capAttributes_.push_back({material, shared::NO_NORMAL, shared::NO_NORMAL, shared::NO_NORMAL});
  }

  void add(const Mesh& mesh) {
    if (packed_.space.wide()) packed_.splits.push_back(splitMesh(mesh, packed_.space));
    if (mesh.sphere)
      addSphere(mesh);
    else if (packed_.splits.empty() || !packed_.splits.back())
      addTriangles(mesh, nullptr);
    else
      addTriangles(packed_.splits.back()->mesh, &packed_.splits.back()->pieces);
  }

  /// `pieces`: of a mesh that was split.
  void addTriangles(const Mesh& mesh, const std::vector<Piece>* pieces) {
    std::vector<vec3> positions(mesh.positions.size());
    std::transform(mesh.positions.begin(), mesh.positions.end(), positions.begin(),
                   [&](const dvec3& p) { return vec3(packed_.space.apply(p)); });
    const bool smooth = uploads_.normals && !mesh.normals.empty();
    const auto firstNormal = static_cast<std::uint32_t>(packed_.normals.size());
    if (smooth)
      for (const dvec3& n : mesh.normals) packed_.normals.emplace_back(vec3(n), 0.0F);
    const std::uint32_t material = addMaterial(mesh);
    if (pieces != nullptr && mesh.light) addWholes(mesh, *pieces, {material, firstNormal});
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3 given = mesh.triangles[i];
      glm::uvec3 t = given;
      const std::uint32_t flipped = sortCorners(t, positions) ? 1 : 0;
      const vec3 a = positions[t.x], b = positions[t.y], c = positions[t.z];
      const std::uint32_t id = nextId_++;
      if (uploads_.textures && pieces != nullptr)
        textures_.addPiece(mesh, (*pieces)[i], t);
      else if (uploads_.textures)
        textures_.addTriangle(mesh, given, t);
      // An edge of length 0 has no inside, and its neighbours still meet. Triangles whose corners
      // merely became collinear are kept, since they fill gaps that rounding opens next to them.
      if (a == b || b == c || c == a) {
        ++packed_.collapsedTriangles;
        continue;
      }
      triangles_.push_back({a, id, b, 0, c, flipped});
      const glm::uvec3 n = smooth ? t + firstNormal : glm::uvec3(shared::NO_NORMAL);
      attributes_.push_back({material, n.x, n.y, n.z});
    }
  }

  /// What all triangles of a mesh have in common.
  struct Common {
    std::uint32_t material, firstNormal;
  };

  /// The triangles that a mesh had before it was split, with the numbers of their first pieces.
  void addWholes(const Mesh& split, const std::vector<Piece>& pieces, Common common) {
    const Mesh& mesh = scene_.meshes[common.material];
    const bool smooth = uploads_.normals && !mesh.normals.empty();
    std::vector<vec3> positions(split.positions.size());
    std::transform(split.positions.begin(), split.positions.end(), positions.begin(),
                   [&](const dvec3& p) { return vec3(packed_.space.apply(p)); });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i != 0 && pieces[i].triangle == pieces[i - 1].triangle) continue;
      glm::uvec3 t = mesh.triangles[pieces[i].triangle];
      const std::uint32_t flipped = sortCorners(t, positions) ? 1 : 0;
      wholes_.push_back({positions[t.x], nextId_ + static_cast<std::uint32_t>(i), positions[t.y], 0,
                         positions[t.z], flipped});
      const glm::uvec3 n = smooth ? t + common.firstNormal : glm::uvec3(shared::NO_NORMAL);
      wholeAttributes_.push_back({common.material, n.x, n.y, n.z});
    }
  }

  /// Sorts corners by position; true if this reverses the winding.
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
  const Uploads& uploads_;
  Packed& packed_;
  TexturePacker& textures_;
  std::vector<shared::Triangle> triangles_;
  std::vector<shared::Attributes> attributes_;
  std::vector<shared::Triangle> caps_;
  std::vector<shared::Attributes> capAttributes_;
  std::vector<shared::Triangle> wholes_;
  std::vector<shared::Attributes> wholeAttributes_;
  std::uint32_t nextId_ = 0, meshes_ = 0;
};

}  // namespace

std::array<glm::vec4, 2> propertiesOf(const IntegratorUse& integrator, const Packed& packed) {
  std::array<glm::vec4, 2> values{};
  glm::length_t i = 0;
  const auto add = [&](double value) {
    values.at(static_cast<std::size_t>(i / 4))[i % 4] = static_cast<float>(value);
    ++i;
  };
  const double scale = packed.space.scale;
  for (const PropertyRow& property : integrator.row->properties) {
    const std::string_view unit = property.unit;
    if (isTriple(property.type)) {
      dvec3 triple = integrator.triple(property.name);
      if (unit == kSceneUnits) triple = packed.space.apply(triple);
      if (unit == kPowers) triple *= scale * scale;
      for (int axis = 0; axis < 3; ++axis) add(triple[axis]);
      continue;
    }
    double value = integrator.real(property.name);
    if (unit == kDiagonals) value *= packed.diagonal;
    const bool length = unit == kSceneUnits || unit == kDiagonals;
    add(length ? std::clamp(value * scale, 0x1p-100, packed.space.reach) : value);
  }
  return values;
}

Packed pack(const Scene& scene, const RenderOptions& options, const Uploads& uploads) {
  Packed packed;
  packed.space = uploads.space;
  packed.diagonal = diagonalOf(boundsOf(scene));
  TexturePacker textures(packed, uploads.textureKinds);
  MeshPacker meshes(scene, uploads, packed, textures);
  const auto triangles = meshes.pack();
  packed.triangles = triangles.size();
  const auto start = std::chrono::steady_clock::now();
  packed.bvh = buildBvh(triangles, options.threads);
  packed.buildSeconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  packed.attributeFormat = attributeFormat(uploads);
  std::vector<shared::Attributes> attributes;
  if (uploads.attributes) attributes = inLeafOrder(meshes.attributes(), triangles, packed.bvh);
  packed.params.firstCap = static_cast<std::uint32_t>(packed.bvh.triangles.size());
  packed.params.capCount = static_cast<std::uint32_t>(meshes.caps().size());
  packed.triangles += packed.params.capCount;
  const auto append = [](auto& all, const auto& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  append(packed.bvh.triangles, meshes.caps());
  append(packed.bvh.triangles, meshes.wholes());
  if (uploads.attributes) {
    append(attributes, meshes.capAttributes());
    append(attributes, meshes.wholeAttributes());
    packAttributes(attributes, uploads, packed);
  }
  if (uploads.lights)
    for (const PointLight& light : scene.lights)
      packed.lights.push_back(packedLight(light, packed.space));
  packCamera(scene.camera, packed);
  packFilter(scene.filter, uploads.noriTable, packed.params);
  packSampler(scene, uploads.jumpLevels, packed);
  if (uploads.background) textures.packBackground(*scene.environment);
  if (uploads.emission) packSources(scene, packed);
  if (!scene.meshes.empty()) packed.params.albedo = vec3(albedoOf(scene.meshes.front()));
  packed.params.root = packed.bvh.root;
  packed.params.packetWindow = packetWindow(primitivesOf(scene));
  return packed;
}

}  // namespace laver
