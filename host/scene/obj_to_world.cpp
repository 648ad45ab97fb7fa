#include <algorithm>
#include <cmath>

#include "scene/obj_data.h"
#include "scene/transform.h"

namespace laver::obj {
namespace {

bool isFinite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Exactly zero, and not for underflow: the edges are scaled by a power of two first.
bool hasNoArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto scaled = [](glm::dvec3 e) {
    int exponent = 0;
    std::frexp(std::max({std::abs(e.x), std::abs(e.y), std::abs(e.z)}), &exponent);
    return glm::dvec3(std::ldexp(e.x, -exponent), std::ldexp(e.y, -exponent),
                      std::ldexp(e.z, -exponent));
  };
  glm::dvec3 cross = glm::cross(b - a, c - a);
  // Only a suspiciously small result can be underflow.
  if (cross == glm::dvec3(0.0)) cross = glm::cross(scaled(b - a), scaled(c - a));
  return cross == glm::dvec3(0.0);
}

}  // namespace

bool toWorld(const ObjData& data, const glm::dmat4& toWorld, Mesh& mesh) {
  const bool affine = isAffine(toWorld);
  mesh.positions.clear();
  mesh.positions.reserve(data.positions.size());
  for (const glm::dvec3& p : data.positions) {
    const glm::dvec4 q = toWorld * glm::dvec4(p, 1.0);
    const glm::dvec3 world = affine ? glm::dvec3(q) : glm::dvec3(q) / q.w;
    if (!isFinite(world)) return false;
    mesh.positions.push_back(world);
  }
  const glm::dmat3 turn = normalMatrix(toWorld);
  mesh.normals.clear();
  mesh.normals.reserve(data.normals.size());
  for (const glm::dvec3& n : data.normals) {
    mesh.normals.push_back(normalizedOrZero(turn * normalizedOrZero(n)));
  }
  mesh.uvs = data.uvs;
  mesh.triangles.clear();
  mesh.triangles.reserve(data.triangles.size());
  for (const glm::uvec3& t : data.triangles) {
    if (hasNoArea(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z])) continue;
    mesh.triangles.push_back(t);
  }
  mesh.droppedTriangles = data.triangles.size() - mesh.triangles.size();
  return true;
}

}  // namespace laver::obj
