#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/space.h"
#include "scene/meshes.h"

namespace laver {

/// Triangles of a wide space (space.h) that are large beside their distance from its centre are
/// split until none of their edges is longer than twice max(distance of the edge, unit). Floats
/// then hold each piece to some e of its own distance, however far its triangle reaches.
///
/// Whether an edge is split, always at its middle, depends on that edge alone, so that neighbours
/// agree and no crack opens, whatever the order of the splits.
///
/// A piece that holds a point p reaches no farther than 12 max(|p|, unit) from the centre. Let h be
/// that maximum. Where the foot of the centre on the plane lies inside, some edge is seen from the
/// foot over 120 degrees or more, so that at a distance s from it that edge is longer than 3.46 s;
/// it is no longer than 2 sqrt(s^2 + h^2); so s <= 0.71 h, and the edge is below 2.5 h and its ends
/// within 3.7 h. The other edges begin there and are below 7.4 h, and the third corner is within
/// 11.1 h. Elsewhere the line from the foot to p meets an edge as near as p or nearer.

/// A part of a triangle.
struct Piece {
  glm::uvec3 corners;                 ///< vertices of the split mesh
  std::uint32_t triangle;             ///< of the mesh that was split
  std::array<glm::dvec3, 3> weights;  ///< of that triangle's corners, at each of its own
};

/// A mesh with more vertices; its triangles are those of the pieces.
struct SplitMesh {
  Mesh mesh;
  std::vector<Piece> pieces;
};

/// None where no triangle is split.
std::optional<SplitMesh> splitMesh(const Mesh& mesh, const Normalisation& space);

/// The piece of a triangle that holds the point with these weights, as its corners: what
/// splitMesh() makes.
std::array<glm::dvec3, 3> pieceAt(const std::array<glm::dvec3, 3>& triangle, glm::dvec3 weights,
                                  const Normalisation& space);

}  // namespace laver
