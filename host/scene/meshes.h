#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/bsdfs.h"
#include "scene/emitters.h"
#include "scene/form.h"
#include "scene/rows.h"

namespace laver {

/// A type of geometry.
struct MeshRow {
  const char* name;
  const char* object = "";  ///< Nori's class, in the dump
  std::vector<Form> forms{};
};

namespace meshes {
extern const MeshRow obj, sphere;
}  // namespace meshes

const Rows<MeshRow>& meshRows();

/// A sphere in world space; its normal points outwards.
struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 1.0;
};

/// Triangles in world space. Attributes are empty or hold one entry per vertex.
struct Mesh {
  std::string name;              ///< file name in the scene
  std::optional<Sphere> sphere;  ///< instead of triangles
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  ///< unit length
  std::vector<glm::dvec2> uvs;
  std::vector<glm::uvec3> triangles;   ///< vertex indices, in file order
  std::uint64_t droppedTriangles = 0;  ///< of zero area, dropped when the file was read
  Bsdf bsdf;
  std::optional<AreaLight> light;  ///< its surface emits

  /// Number of triangles, or 1 for a sphere.
  std::size_t primitives() const { return sphere ? 1 : triangles.size(); }
  const MeshRow& row() const { return sphere ? meshes::sphere : meshes::obj; }
};

}  // namespace laver
