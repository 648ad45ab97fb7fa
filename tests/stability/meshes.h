#pragma once
#include <functional>
#include <random>
#include <vector>

#include "bvh/bvh.h"
#include "scene/scene.h"

namespace laver::test {

/// A closed mesh as the kernels see it: float corners, a tree, triangles with a corner in common
/// share its bits.
struct ClosedMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;  ///< in file order; the tree lacks those that collapsed
  Bvh bvh;
};

/// The tree with corners as the triangles list them, for methods that do not sort.
Bvh inListedOrder(const ClosedMesh& mesh);

/// Sorts corners and leaves out triangles with two equal corners, as the renderer's packing does.
ClosedMesh closedMesh(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles);

/// A bumpy sphere of 81,590 triangles, half-width about `radius`, around `centre`, rounded there.
/// Any point within 0.3 radii of the centre sees the whole inside: every ray from it crosses the
/// surface exactly once.
ClosedMesh closedBumpySphere(double radius, glm::dvec3 centre);

/// A direction from `origin` to a point on an edge, a vertex where `vertex`, of a random triangle,
/// rounded to float.
glm::vec3 aimedRay(const ClosedMesh& mesh, glm::vec3 origin, bool vertex, std::mt19937& random);

/// Calls body(first, random) for each batch of `batch` of `count` rays on all threads; each batch
/// of each `seed` has its own random numbers, so that results do not depend on the threads.
void forBatches(std::uint64_t count, std::uint64_t batch, std::uint64_t seed,
                const std::function<void(std::uint64_t, std::mt19937&)>& body);

}  // namespace laver::test
