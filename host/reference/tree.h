#pragma once
#include <optional>
#include <vector>

#include "reference/build.h"
#include "reference/triangle.h"

namespace laver::reference {

/// The nearest hit of a ray.
struct TreeHit {
  const Triangle* triangle;
  double t;         ///< at the triangle's plane
  Weights weights;  ///< of the triangle's sorted corners
};

/// A tree over triangles, whose answers equal those of a loop over all triangles.
class Tree {
 public:
  /// `threads` host threads, 0: all. Throws Error(Scene) for 2^31 triangles or more.
  explicit Tree(std::vector<Triangle> triangles, unsigned threads = 0);

  /// The hit with the smallest t in [tmin, tmax]; of equal ones that with the smallest id.
  std::optional<TreeHit> closest(const Ray& ray, double tmin, double tmax) const;

  /// The first crossing of a ray that starts beside a surface, where rounding may give a crossing
  /// of that surface any t near 0: the sides of the planes decide, as in blocked().
  std::optional<TreeHit> closestAhead(const Ray& ray) const;

  /// Whether any triangle lies between two points: the line through them intersects it, and its
  /// plane separates them.
  bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  template <typename Test>
  std::optional<TreeHit> nearest(const Ray& ray, double tmin, double tmax, const Test& test) const;
  template <typename Visit>
  void walk(const Ray& ray, double tmin, double tmax, const Visit& visit) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace laver::reference
