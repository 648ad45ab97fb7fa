#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace laver::obj {

/// A polygon cut into triangles of corner indices, which wind as the polygon does.
struct Triangulation {
  std::vector<glm::uvec3> triangles;  ///< two fewer than corners
  bool crossesItself = false;         ///< some parts are then covered twice or not at all
};

/// Cuts a polygon of three or more corners in its own plane: a convex one into a fan around the
/// first corner, any other by ear clipping (Meisters 1975), in O(n log n + n k) time for k corners
/// within the width of an ear. Corners may repeat, as at a slit that leads to a hole.
Triangulation triangulate(const std::vector<glm::dvec3>& corners);

}  // namespace laver::obj
