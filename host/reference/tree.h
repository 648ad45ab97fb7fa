#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "reference/build.h"
#include "reference/exact_depth.h"
#include "reference/triangle.h"

namespace laver::reference {

/// The nearest hit of a ray.
struct TreeHit {
  const Triangle* triangle;
  double t;         ///< at the triangle's plane
  Weights weights;  ///< of the triangle's sorted corners
};

/// The triangles of a tree before they were rounded: the corners of the one with a number, and the
/// origin of the tree's coordinates.
struct Originals {
  std::function<Corners(std::uint32_t id)> corners;
  glm::dvec3 centre{0.0};
};

/// A tree over triangles, whose answers equal those of a loop over all triangles. Which of two
/// triangles is nearer is decided in exact arithmetic where double precision cannot.
class Tree {
 public:
  /// `threads` host threads, 0: all. Throws Error(Scene) for 2^31 triangles or more. Without
  /// `originals` the triangles are exact.
  explicit Tree(std::vector<Triangle> triangles, unsigned threads = 0, Originals originals = {});

  /// The hit with the smallest t in [tmin, tmax]; of equal ones that with the smallest id.
  std::optional<TreeHit> closest(const Ray& ray, double tmin, double tmax) const;

  /// The first crossing of a ray that starts beside a surface, where rounding may give a crossing
  /// of that surface any t near 0: the sides of the planes decide, as in blocked().
  std::optional<TreeHit> closestAhead(const Ray& ray) const;

  /// Whether any triangle lies between two points: the line through them intersects it, and its
  /// plane separates them.
  bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  bool nearer(const Ray& ray, const TreeHit& one, const TreeHit& other) const;
  template <typename Test>
  std::optional<TreeHit> nearest(const Ray& ray, double tmin, double tmax, const Test& test) const;
  template <typename Visit>
  void walk(const Ray& ray, double tmin, double tmax, const Visit& visit) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  Originals originals_;
};

}  // namespace laver::reference
