#include "render/split_meshes.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace laver {
namespace {

using glm::dvec3;

/// Of the segment from p to q, squared, from the origin.
double squaredDistance(dvec3 p, dvec3 q) {
  const dvec3 along = q - p;
  const double length = glm::dot(along, along);
  const double at = length > 0.0 ? std::clamp(-glm::dot(p, along) / length, 0.0, 1.0) : 0.0;
  const dvec3 nearest = p + along * at;
  return glm::dot(nearest, nearest);
}

/// Squared length of an edge that is to be split, else 0; the same for both directions.
double tooLong(dvec3 p, dvec3 q, const Normalisation& space) {
  if (std::tie(q.x, q.y, q.z) < std::tie(p.x, p.y, p.z)) std::swap(p, q);
  const double length = glm::dot(q - p, q - p);
  if (length <= 4.0 * space.unit * space.unit) return 0.0;
  return length > 4.0 * squaredDistance(p - space.centre, q - space.centre) ? length : 0.0;
}

/// The longest edge that is to be split, as the number of the corner that it begins at; -1 for
/// none.
int edgeToSplit(const std::array<dvec3, 3>& p, const Normalisation& space) {
  int edge = -1;
  double longest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double length =
        tooLong(p[static_cast<std::size_t>(i)], p[static_cast<std::size_t>((i + 1) % 3)], space);
    if (length <= longest) continue;
    longest = length;
    edge = i;
  }
  return edge;
}

dvec3 middle(dvec3 p, dvec3 q) { return p * 0.5 + q * 0.5; }

class Splitter {
 public:
  Splitter(const Mesh& mesh, const Normalisation& space) : space_(space) { result_.mesh = mesh; }

  SplitMesh run() {
    const std::vector<glm::uvec3> whole = std::move(result_.mesh.triangles);
    result_.mesh.triangles.clear();
    for (std::uint32_t i = 0; i < whole.size(); ++i)
      add({whole[i], i, {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}});
    return std::move(result_);
  }

 private:
  void add(const Piece& first) {
    std::vector<Piece> waiting{first};
    while (!waiting.empty()) {
      const Piece piece = waiting.back();
      waiting.pop_back();
      const glm::uvec3 c = piece.corners;
      const auto& p = result_.mesh.positions;
      const int edge = edgeToSplit({p[c[0]], p[c[1]], p[c[2]]}, space_);
      if (edge < 0) {
        result_.mesh.triangles.push_back(c);
        result_.pieces.push_back(piece);
        continue;
      }
      const int next = (edge + 1) % 3;
      const std::uint32_t vertex = addMiddle(c[edge], c[next]);
      const auto a = static_cast<std::size_t>(edge), b = static_cast<std::size_t>(next);
      Piece one = piece, other = piece;
      one.corners[next] = other.corners[edge] = vertex;
      one.weights[b] = other.weights[a] = middle(piece.weights[a], piece.weights[b]);
      waiting.push_back(other);
      waiting.push_back(one);
    }
  }

  std::uint32_t addMiddle(std::uint32_t i, std::uint32_t j) {
    Mesh& mesh = result_.mesh;
    mesh.positions.push_back(middle(mesh.positions[i], mesh.positions[j]));
    // Not of unit length: normals are interpolated before they are normalised.
    if (!mesh.normals.empty()) mesh.normals.push_back(middle(mesh.normals[i], mesh.normals[j]));
    if (!mesh.uvs.empty()) mesh.uvs.push_back(mesh.uvs[i] * 0.5 + mesh.uvs[j] * 0.5);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  }

  const Normalisation& space_;
  SplitMesh result_;
};

}  // namespace

std::optional<SplitMesh> splitMesh(const Mesh& mesh, const Normalisation& space) {
  if (!space.wide()) return {};
  const auto& p = mesh.positions;
  if (std::none_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
        return edgeToSplit({p[t.x], p[t.y], p[t.z]}, space) >= 0;
      }))
    return {};
  return Splitter(mesh, space).run();
}

std::array<dvec3, 3> pieceAt(const std::array<dvec3, 3>& triangle, dvec3 weights,
                             const Normalisation& space) {
  std::array<dvec3, 3> piece = triangle;
  for (int edge; space.wide() && (edge = edgeToSplit(piece, space)) >= 0;) {
    const auto a = static_cast<std::size_t>(edge), b = static_cast<std::size_t>((edge + 1) % 3);
    const bool first = weights[edge] >= weights[(edge + 1) % 3];
    // wa A + wb B = (wa - wb) A + 2 wb M, and the other way round.
    (first ? piece[b] : piece[a]) = middle(piece[a], piece[b]);
    double& kept = weights[first ? edge : (edge + 1) % 3];
    double& moved = weights[first ? (edge + 1) % 3 : edge];
    kept -= moved;
    moved *= 2.0;
  }
  return piece;
}

}  // namespace laver
