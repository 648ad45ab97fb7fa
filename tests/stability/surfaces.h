#pragma once
#include <functional>

#include "scene/scene.h"
#include "stability/subject.h"

namespace laver::test {

/// A mesh of cells x cells quads, two triangles each, over [-1, 1]^2.
Mesh gridMesh(int cells, const std::function<glm::dvec3(double, double)>& place);

/// The triangles of a mesh as floats in its own space, corners as listed.
std::vector<shared::Triangle> listedTriangles(const Mesh& mesh);

/// Where the kernels end the shadow ray to a light: beside the point that `ray` met, as
/// direct_whitted.comp has it. A device's text is that of the optimised twin.
glm::vec3 shadowPoint(const Subject& subject, const Bvh& bvh, const TestRay& ray, std::uint32_t id,
                      glm::vec3 light);

}  // namespace laver::test
