#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "reference/triangle.h"

namespace laver::reference {

/// Axis-aligned box, faces included; holds nothing at first.
struct Box {
  glm::dvec3 lo{std::numeric_limits<double>::infinity()};
  glm::dvec3 hi{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& point) {
    lo = glm::min(lo, point);
    hi = glm::max(hi, point);
  }
  void add(const Box& box) {
    lo = glm::min(lo, box.lo);
    hi = glm::max(hi, box.hi);
  }
};

/// A node of a binary tree over a list of triangles. An inner node's first child is the node
/// after it.
struct Node {
  Box box;                  ///< of all the triangles below, exact
  std::uint32_t count = 0;  ///< triangles of a leaf; 0: an inner node
  std::uint32_t next = 0;   ///< a leaf's first triangle; an inner node's second child
};

/// Inner nodes above a leaf, at most.
constexpr int maxDepth = 40 + 32;

/// Puts the triangles, fewer than 2^31, into the order of the leaves and returns the tree over
/// them, root first; it is empty if there is no triangle. The result does not depend on `threads`
/// (0: all).
///
/// Splits where the surface area heuristic is cheapest among 16 bins along the longest axis of
/// the centroids' box (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies",
/// 2007); from depth 40 on at the median, which bounds the depth.
std::vector<Node> buildTree(std::vector<Triangle>& triangles, unsigned threads);

}  // namespace laver::reference
