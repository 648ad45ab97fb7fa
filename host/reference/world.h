#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "reference/camera.h"
#include "reference/sphere.h"
#include "reference/tree.h"
#include "scene/scene.h"

namespace laver::reference {

/// The surface at a hit, in coordinates relative to World::centre().
struct Surface {
  glm::dvec3 position;   ///< the weighted mean of the corners
  glm::dvec3 geometric;  ///< unit normal of the triangle's plane, oriented by the winding
  glm::dvec3 shading;    ///< unit normal from the vertex normals, else the geometric one
  glm::dvec2 textureUv;  ///< of textures: barycentric weights without coordinates
  const Mesh* mesh;      ///< of the primitive
  double offset;         ///< bound of the rounding of `position` along the normal
  glm::dvec2 uv;         ///< of a sphere, or interpolated from vertices; 0 without coordinates
  /// Of normal maps: along u of textureUv, on a sphere along the meridian from +z; any length, 0 if
  /// there is none.
  glm::dvec3 tangent{0.0};
};

/// The nearest hit of a ray: a triangle, or else a sphere.
struct WorldHit {
  double t;
  std::optional<TreeHit> triangle;
  const WorldSphere* sphere = nullptr;
  glm::dvec3 normal{0.0};  ///< of the sphere

  std::uint32_t id() const { return triangle ? triangle->triangle->id : sphere->id; }
};

/// A scene's primitives, numbered in file order over all meshes: triangles in a tree, spheres,
/// which are few, in a list. Coordinates are relative to the point of the meshes' box that is
/// nearest to the camera, which preserves digits where they show: distant parts of the scene cost
/// nearby ones no accuracy.
class World {
 public:
  /// The scene must outlive this object. `threads` host threads, 0: all.
  World(const Scene& scene, unsigned threads);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  glm::dvec3 centre() const { return centre_; }
  /// The scene's point lights, relative to the centre.
  const std::vector<PointLight>& lights() const { return lights_; }
  double diagonal() const { return glm::length(box_.hi - box_.lo); }
  /// Larger than the distance between any two points of the meshes.
  double extent() const { return 2.0 * glm::length(box_.hi - box_.lo); }
  /// The hit with the smallest t in [tmin, tmax]; of equal ones that with the smallest number.
  std::optional<WorldHit> closest(const Ray& ray, double tmin, double tmax) const;
  /// The same of a ray that starts beside a surface.
  std::optional<WorldHit> closestAhead(const Ray& ray) const;
  /// Whether any primitive lies between two points.
  bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;
  Surface surface(const WorldHit& hit) const;
  /// A point of a primitive, uniform by area for uniform numbers.
  Surface surfaceOn(std::uint32_t id, glm::dvec2 numbers) const;
  /// The mesh of a primitive's number, and the number of a mesh's first primitive.
  std::size_t meshOf(std::uint32_t id) const;
  std::uint64_t firstOf(std::size_t mesh) const { return first_[mesh]; }

 private:
  Originals originals() const;
  std::optional<WorldHit> nearest(const std::optional<TreeHit>& triangle, const Ray& ray,
                                  double tmin, double tmax) const;
  Surface surface(const TreeHit& hit) const;
  std::vector<Triangle> gather() const;

  const Scene* scene_;
  std::vector<std::uint64_t> first_;  // number of each mesh's first triangle
  Box box_;
  glm::dvec3 centre_;
  std::vector<WorldSphere> spheres_;
  std::vector<PointLight> lights_;
  Tree tree_;
};

}  // namespace laver::reference
