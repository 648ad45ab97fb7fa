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

/// The point that a ray met, in coordinates relative to World::centre().
struct Surface {
  glm::dvec3 position;   ///< the weighted mean of the corners
  glm::dvec3 geometric;  ///< unit normal of the triangle's plane, by its winding
  glm::dvec3 shading;    ///< unit normal from the vertex normals, else the geometric one
  glm::dvec3 albedo;
  const Mesh* mesh;  ///< that it belongs to
  double offset;     ///< distance along a normal that no rounding of `position` exceeds
  glm::dvec2 uv;     ///< of a sphere, or interpolated from vertices; 0 where they have none
};

/// What a ray met first: a triangle, or else a sphere.
struct Met {
  double t;
  std::optional<TreeHit> triangle;
  const Ball* ball = nullptr;
  glm::dvec3 normal{0.0};  ///< of the sphere

  std::uint32_t id() const { return triangle ? triangle->triangle->id : ball->id; }
};

/// A scene's triangles in a tree, numbered in file order over all meshes. Coordinates are relative
/// to the centre of the meshes' box, which spares digits where a scene lies far from 0. Spheres,
/// which are few, are in a list.
class World {
 public:
  /// The scene must outlive it. `threads` host threads, 0: all.
  World(const Scene& scene, unsigned threads);

  glm::dvec3 centre() const { return 0.5 * box_.lo + 0.5 * box_.hi; }
  /// The scene's point lights, relative to the centre.
  const std::vector<PointLight>& lights() const { return lights_; }
  /// Farther than any two points of the meshes are apart.
  double extent() const { return 2.0 * glm::length(box_.hi - box_.lo); }
  /// The first hit with t in [tmin, tmax]; of equal ones that of the smallest number.
  std::optional<Met> closest(const Ray& ray, double tmin, double tmax) const;
  /// The same of a ray that starts beside a surface.
  std::optional<Met> closestAhead(const Ray& ray) const;
  /// Whether anything lies between two points.
  bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;
  Surface surface(const Met& met) const;
  /// A point of a primitive, uniform by area for uniform numbers.
  Surface surfaceOn(std::uint32_t id, glm::dvec2 numbers) const;
  /// The mesh of a triangle's number, and the number of that mesh's first one.
  std::size_t meshOf(std::uint32_t id) const;
  std::uint64_t firstOf(std::size_t mesh) const { return first_[mesh]; }

 private:
  std::optional<Met> nearest(const std::optional<TreeHit>& triangle, const Ray& ray, double tmin,
                             double tmax) const;
  Surface surface(const TreeHit& hit) const;
  std::vector<Triangle> gather() const;

  const Scene* scene_;
  std::vector<std::uint64_t> first_;  // number of each mesh's first triangle
  Box box_;
  std::vector<Ball> balls_;
  std::vector<PointLight> lights_;
  Tree tree_;
};

}  // namespace laver::reference
