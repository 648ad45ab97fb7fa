#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace laver::obj {

/// A polygon cut into triangles, which are numbers of its corners and wind as the polygon does.
struct Triangulation {
  std::vector<glm::uvec3> triangles;  ///< as many as corners, less two
  bool crossesItself = false;         ///< then parts are covered twice, or not at all
};

/// Cuts a polygon of three corners or more in its own plane: a convex one into a fan about the
/// first corner, any other by clipping ears (Meisters 1975), at a cost of O(n log n + n k) for k
/// corners that lie within the width of an ear. Corners may repeat, as where a slit leads to a
/// hole.
Triangulation triangulate(const std::vector<glm::dvec3>& corners);

}  // namespace laver::obj
