#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "reference/triangle.h"

namespace laver::reference {

/// Axis-aligned box, faces included; initially empty.
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

/// A node of a binary tree over a list of triangles. The first child of an inner node is the next
/// node.
struct Node {
  Box box;                  ///< exact bounds of all triangles below
  std::uint32_t count = 0;  ///< triangles of a leaf; 0: an inner node
  std::uint32_t next = 0;   ///< a leaf's first triangle; an inner node's second child
};

/// Maximum number of inner nodes above a leaf.
constexpr int maxDepth = 40 + 32;

/// Sorts the triangles, fewer than 2^31, into the order of the leaves and returns the tree over
/// them, root first; empty if there are no triangles. The result does not depend on `threads` (0:
/// all).
///
/// Splits where the surface area heuristic is minimal among 16 bins along the longest axis of the
/// centroids' box (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007);
/// from depth 40 on at the median, which bounds the depth.
std::vector<Node> buildTree(std::vector<Triangle>& triangles, unsigned threads);

}  // namespace laver::reference
