// Meshes in world space.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "scene/obj.h"

namespace laver::test {
namespace {

obj::ObjData triangle() {
  obj::ObjData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.normals = {{0, 0, 2}, {1, 1, 0}, {0, 0, 0}};
  data.triangles = {{0, 1, 2}};
  return data;
}

Mesh transformed(const obj::ObjData& data, const glm::dmat4& matrix) {
  const std::optional<Mesh> mesh = obj::toWorld(data, matrix);
  EXPECT_TRUE(mesh);
  return mesh.value_or(Mesh());
}

TEST(ObjToWorld, NormalsUseTheInverseTransposeAndHaveUnitLength) {
  const Mesh mesh = transformed(triangle(), glm::scale(glm::dmat4(1), glm::dvec3(2, 1, 1)));
  EXPECT_EQ(mesh.positions[1], glm::dvec3(2, 0, 0));
  EXPECT_EQ(mesh.normals[0], glm::dvec3(0, 0, 1));
  EXPECT_DOUBLE_EQ(mesh.normals[1].x, 1 / std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(mesh.normals[1].y, 2 / std::sqrt(5.0));
  EXPECT_EQ(mesh.normals[2], glm::dvec3(0));
}

TEST(ObjToWorld, MirroringChangesNormalsButNotTheWinding) {
  obj::ObjData data = triangle();
  data.normals = {{1, 0, 0}, {1, 1, 0}, {0, 0, 1}};
  const Mesh mesh = transformed(data, glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)));
  EXPECT_EQ(mesh.normals[0], glm::dvec3(-1, 0, 0));
  EXPECT_EQ(mesh.normals[2], glm::dvec3(0, 0, 1));
  EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
}

TEST(ObjToWorld, ExtremeScalesKeepNormals) {
  for (const double scale : {1e-200, 1e200}) {
    const Mesh mesh = transformed(triangle(), glm::scale(glm::dmat4(1), glm::dvec3(scale)));
    EXPECT_EQ(mesh.normals[0], glm::dvec3(0, 0, 1)) << scale;
    EXPECT_EQ(mesh.triangles.size(), 1u) << scale;
  }
}

TEST(ObjToWorld, NonFiniteNormalsBecomeZero) {
  obj::ObjData data = triangle();
  data.normals[0] = {std::numeric_limits<double>::infinity(), 0, 0};
  data.normals[1] = {1e308, 1e308, 0};
  const Mesh mesh = transformed(data, glm::dmat4(1));
  EXPECT_EQ(mesh.normals[0], glm::dvec3(0));
  EXPECT_DOUBLE_EQ(mesh.normals[1].x, std::sqrt(0.5));
}

TEST(ObjToWorld, PerspectiveDividesPoints) {
  glm::dmat4 matrix(1);
  matrix[0][3] = 1;  // w = x + 1
  const Mesh mesh = transformed(triangle(), matrix);
  EXPECT_EQ(mesh.positions[1], glm::dvec3(0.5, 0, 0));
  matrix[3][3] = -1;  // w = x - 1
  EXPECT_FALSE(obj::toWorld(triangle(), matrix));
}

TEST(ObjToWorld, TrianglesWithoutAreaAreDroppedAndCounted) {
  obj::ObjData data;
  data.positions = {{0, 0, 0}, {.1, .1, .1}, {.3, .3, .3}, {1, 0, 0}, {0, 0, 0}};
  data.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 3}, {0, 4, 3}};
  const Mesh mesh = transformed(data, glm::dmat4(1));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 3));
  EXPECT_EQ(mesh.droppedTriangles, 3u);
  EXPECT_EQ(mesh.positions.size(), 5u);
}

TEST(ObjToWorld, IdentityChangesNoBit) {
  obj::ObjData data = triangle();
  data.positions[1] = {0.1, -0.0, 1e-300};
  EXPECT_EQ(transformed(data, glm::dmat4(1)).positions, data.positions);
}

}  // namespace
}  // namespace laver::test
