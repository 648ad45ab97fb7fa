#pragma once
#include <functional>
#include <random>
#include <vector>

#include "bvh/bvh.h"
#include "scene/scene.h"

namespace laver::test {

/// A closed mesh as the kernels see it: float corners, identical bits for shared corners, a tree.
struct ClosedMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;  ///< in file order; the tree lacks degenerate ones
  Bvh bvh;
};

/// The tree with corners in the order of the mesh, for methods that do not sort them.
Bvh inListedOrder(const ClosedMesh& mesh);

/// Sorts corners and drops triangles with two equal corners, as the renderer's packing does.
ClosedMesh closedMesh(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles);

/// A bumpy sphere of 81,590 triangles around `centre`, half-width about `radius`, rounded to float
/// there. From any point within 0.3 radii of the centre, every ray crosses the surface exactly
/// once.
ClosedMesh closedBumpySphere(double radius, glm::dvec3 centre);

/// The direction from `origin` to a point on an edge of a random triangle, or to a vertex if
/// `vertex`, rounded to float.
glm::vec3 aimedRay(const ClosedMesh& mesh, glm::vec3 origin, bool vertex, std::mt19937& random);

/// Calls body(first, random) for each batch of `batch` of `count` rays on all threads. The random
/// numbers depend on `seed` and the batch only, so that results do not depend on the threads.
void forBatches(std::uint64_t count, std::uint64_t batch, std::uint64_t seed,
                const std::function<void(std::uint64_t, std::mt19937&)>& body);

}  // namespace laver::test
