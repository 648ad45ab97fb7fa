// Transforms: singularity, look-at cameras, rotations, normals.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "scene/transform.h"

namespace laver::test {
namespace {

const glm::dmat4 kOne(1.0);
glm::dmat4 turn() { return *rotation({1, 2, 3}, 40.0); }
glm::dmat4 scaled(double x, double y, double z) { return glm::scale(kOne, glm::dvec3(x, y, z)); }

TEST(TransformSingular, DoesNotDependOnScale) {
  EXPECT_FALSE(isSingular(kOne));
  EXPECT_FALSE(isSingular(scaled(1e-200, 1e-200, 1e-200)));
  EXPECT_FALSE(isSingular(scaled(1e200, 1e200, 1e200)));
  EXPECT_FALSE(isSingular(scaled(1e-100, 1, 1e100)));
  EXPECT_FALSE(isSingular(scaled(-1, 1, 1)));
  EXPECT_FALSE(isSingular(scaled(1e-20, 1, 1) * turn()));
  EXPECT_FALSE(isSingular(turn() * scaled(1e-20, 1, 1)));
  EXPECT_FALSE(isSingular(turn() * scaled(1e-9, 1, 1) * turn()));
  EXPECT_FALSE(isSingular(glm::translate(kOne, glm::dvec3(1e30, 0, 0)) * scaled(1e-9, 1e-9, 1e-9)));
  EXPECT_FALSE(isSingular(glm::perspective(1.0, 1.5, 0.1, 100.0)));
}

TEST(TransformSingular, WhenADirectionIsLost) {
  EXPECT_TRUE(isSingular(scaled(1, 0, 1)));
  EXPECT_TRUE(isSingular(turn() * scaled(1, 0, 1)));
  EXPECT_TRUE(isSingular(scaled(1, 0, 1) * turn()));
  EXPECT_TRUE(isSingular(turn() * scaled(1, 0, 1) * turn()));
  EXPECT_TRUE(isSingular(turn() * scaled(1e-8, 0, 1e-8) * turn()));
  EXPECT_TRUE(isSingular(glm::dmat4(1, 4, 7, 0, 2, 5, 8, 0, 3, 6, 9, 0, 0, 0, 0, 1)));
  EXPECT_TRUE(isSingular(glm::dmat4(0.0)));
  glm::dmat4 noW(1.0);
  noW[3][3] = 0.0;
  EXPECT_TRUE(isSingular(noW));
}

TEST(TransformSingular, WhenNotFinite) {
  glm::dmat4 matrix(1.0);
  matrix[2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(isSingular(matrix));
  EXPECT_TRUE(isSingular(scaled(std::numeric_limits<double>::infinity(), 1, 1)));
}

TEST(TransformLookAt, ColumnsAreLeftUpViewAndOrigin) {
  const auto matrix = lookAt({1, 2, 3}, {1, 2, 13}, {0, 5, 0});
  ASSERT_TRUE(matrix);
  EXPECT_EQ((*matrix)[0], glm::dvec4(1, 0, 0, 0));
  EXPECT_EQ((*matrix)[1], glm::dvec4(0, 1, 0, 0));
  EXPECT_EQ((*matrix)[2], glm::dvec4(0, 0, 1, 0));
  EXPECT_EQ((*matrix)[3], glm::dvec4(1, 2, 3, 1));
}

TEST(TransformLookAt, IsARotationForAnyUpVector) {
  const auto matrix = lookAt({1, 2, 3}, {-4, 0, 7}, {0.3, 2, 0.1});
  ASSERT_TRUE(matrix);
  const glm::dmat3 r(*matrix);
  EXPECT_NEAR(glm::determinant(r), 1.0, 1e-14);
  EXPECT_NEAR(glm::dot(r[0], r[1]), 0.0, 1e-15);
  EXPECT_NEAR(glm::dot(r[2], glm::normalize(glm::dvec3(-5, -2, 4))), 1.0, 1e-15);
  EXPECT_GT(glm::dot(r[1], glm::dvec3(0.3, 2, 0.1)), 0.0);
}

TEST(TransformLookAt, IsUndefinedWithoutDirections) {
  EXPECT_FALSE(lookAt({1, 2, 3}, {1, 2, 3}, {0, 1, 0}));
  EXPECT_FALSE(lookAt({0, 0, 0}, {0, 0, 1}, {0, 0, 0}));
  EXPECT_FALSE(lookAt({0, 0, 0}, {0.1, 0.2, 0.3}, {1, 2, 3}));
  EXPECT_FALSE(lookAt({1000, 1000, 1000}, {1000.1, 1000.2, 1000.3}, {1, 2, 3}));
  EXPECT_TRUE(lookAt({0, 0, 0}, {0.1, 0.2, 0.3}, {1, 2, 3.000001}));
  EXPECT_TRUE(lookAt({0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}));
}

TEST(TransformRotation, TurnsCounterClockwiseAboutAnAxisOfAnyLength) {
  const auto matrix = rotation({0, 0, 1e-200}, 90.0);
  ASSERT_TRUE(matrix);
  const glm::dvec4 y = *matrix * glm::dvec4(1, 0, 0, 0);
  EXPECT_NEAR(y.x, 0.0, 1e-15);
  EXPECT_NEAR(y.y, 1.0, 1e-15);
  EXPECT_FALSE(rotation({0, 0, 0}, 90.0));
}

TEST(TransformNormals, UseTheInverseTranspose) {
  const glm::dmat4 matrix = turn() * scaled(1, -2, 3) * turn();
  const glm::dmat3 expected = glm::transpose(glm::inverse(glm::dmat3(matrix)));
  const glm::dvec3 n = normalizedOrZero(normalMatrix(matrix) * glm::dvec3(.3, .4, .5));
  const glm::dvec3 m = glm::normalize(expected * glm::dvec3(.3, .4, .5));
  EXPECT_NEAR(glm::distance(n, m), 0.0, 1e-14);
}

}  // namespace
}  // namespace laver::test
