#pragma once
#include <functional>

#include "scene/scene.h"
#include "stability/subject.h"

namespace laver::test {

/// A mesh of cells x cells quads, two triangles each, over [-1, 1]^2.
Mesh gridMesh(int cells, const std::function<glm::dvec3(double, double)>& place);

/// The triangles of a mesh as floats in the mesh's own space, corners as listed.
std::vector<shared::Triangle> listedTriangles(const Mesh& mesh);

/// The origin of the kernels' shadow ray to a light: offset from the point that `ray` hit, as in
/// direct_whitted.glsl. For a device the optimised twin computes it.
glm::vec3 shadowPoint(const Subject& subject, const Bvh& bvh, const TestRay& ray, std::uint32_t id,
                      glm::vec3 light);

}  // namespace laver::test
