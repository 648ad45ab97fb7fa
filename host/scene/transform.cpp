#include "scene/transform.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "core/numeric.h"

namespace laver {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// Divides rows, then columns, by their largest entries. False if one of them is all zero.
template <int N>
bool equilibrate(double (&m)[N][N]) {
  for (auto& row : m) {
    double top = 0.0;
    for (const double x : row) top = std::max(top, std::abs(x));
    if (top == 0.0) return false;
    for (double& x : row) x /= top;
  }
  for (int c = 0; c < N; ++c) {
    double top = 0.0;
    for (int r = 0; r < N; ++r) top = std::max(top, std::abs(m[r][c]));
    if (top == 0.0) return false;
    for (int r = 0; r < N; ++r) m[r][c] /= top;
  }
  return true;
}

// Gaussian elimination with complete pivoting. An entry of at most 1 accumulates a rounding of
// about 2 eps in each of the N - 1 steps, and the entries of a product of a few transforms already
// have an error of some eps: a last pivot of 16 N eps or less (1.1e-14 to 1.4e-14) is
// indistinguishable from 0.
template <int N>
bool singular(double (&m)[N][N]) {
  if (!equilibrate(m)) return true;
  for (int step = 0; step < N; ++step) {
    int row = step, column = step;
    for (int r = step; r < N; ++r) {
      for (int c = step; c < N; ++c) {
        if (std::abs(m[r][c]) > std::abs(m[row][column])) row = r, column = c;
      }
    }
    if (!(std::abs(m[row][column]) > 16.0 * N * kEpsilon)) return true;
    for (int c = 0; c < N; ++c) std::swap(m[step][c], m[row][c]);
    for (int r = 0; r < N; ++r) std::swap(m[r][step], m[r][column]);
    for (int r = step + 1; r < N; ++r) {
      const double factor = m[r][step] / m[step][step];
      for (int c = step; c < N; ++c) m[r][c] -= factor * m[step][c];
    }
  }
  return false;
}

}  // namespace

glm::dvec3 normalizedOrZero(const glm::dvec3& v) {
  const double size = maxNorm(v);
  const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  if (!finite || size == 0.0) return glm::dvec3(0.0);
  // A power of two, so that unit vectors and simple ratios are as exact as without scaling.
  int exponent = 0;
  std::frexp(size, &exponent);
  const glm::dvec3 s(std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent),
                     std::ldexp(v.z, -exponent));
  return s / std::sqrt(glm::dot(s, s));
}

std::optional<glm::dmat4> lookAt(const glm::dvec3& origin, const glm::dvec3& target,
                                 const glm::dvec3& up) {
  const glm::dvec3 view = target - origin;
  const glm::dvec3 dir = normalizedOrZero(view);
  const glm::dvec3 unitUp = normalizedOrZero(up);
  const glm::dvec3 left = glm::cross(unitUp, dir);
  // Each coordinate of origin and target is off by eps/2 of its size, and so is their difference,
  // so dir is off by about eps (|origin| + |target|) / |view|. A cross product below four times
  // that, plus its own rounding, has no meaningful direction.
  const double size = maxNorm(origin) + maxNorm(target);
  const double noise = 4.0 * kEpsilon * (1.0 + size / maxNorm(view));
  if (!(glm::length(left) > noise)) return std::nullopt;
  const glm::dvec3 unitLeft = normalizedOrZero(left);
  const glm::dvec3 newUp = glm::cross(dir, unitLeft);
  return glm::dmat4(glm::dvec4(unitLeft, 0.0), glm::dvec4(newUp, 0.0), glm::dvec4(dir, 0.0),
                    glm::dvec4(origin, 1.0));
}

std::optional<glm::dmat4> scaledLookAt(const glm::dvec3& origin, const glm::dvec3& target,
                                       const glm::dvec3& up) {
  std::optional<glm::dmat4> result = lookAt(origin, target, up);
  if (!result) return result;
  const double sine = glm::length(glm::cross(normalizedOrZero(up), glm::dvec3((*result)[2])));
  (*result)[0] *= sine;
  (*result)[1] *= sine;
  return result;
}

std::optional<glm::dmat4> rotation(const glm::dvec3& axis, double degrees) {
  const glm::dvec3 unit = normalizedOrZero(axis);
  if (unit == glm::dvec3(0.0)) return std::nullopt;
  return glm::rotate(glm::dmat4(1.0), glm::radians(degrees), unit);
}

bool isAffine(const glm::dmat4& m) {
  return m[0][3] == 0.0 && m[1][3] == 0.0 && m[2][3] == 0.0 && m[3][3] == 1.0;
}

bool isSingular(const glm::dmat4& matrix) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      if (!std::isfinite(matrix[c][r])) return true;
    }
  }
  double m3[3][3], m4[4][4];
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      m4[r][c] = matrix[c][r];
      if (r < 3 && c < 3) m3[r][c] = matrix[c][r];
    }
  }
  return isAffine(matrix) ? singular(m3) : singular(m4);
}

glm::dmat3 normalMatrix(const glm::dmat4& matrix) {
  if (!isAffine(matrix)) return glm::transpose(glm::dmat3(glm::inverse(matrix)));
  const double size = std::max({maxNorm(glm::dvec3(matrix[0])), maxNorm(glm::dvec3(matrix[1])),
                                maxNorm(glm::dvec3(matrix[2]))});
  int exponent = 0;
  std::frexp(size, &exponent);
  glm::dvec3 column[3];
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) column[c][r] = std::ldexp(matrix[c][r], -exponent);
  }
  // The cofactors are the inverse transpose times the determinant, of which only the sign matters.
  const glm::dmat3 cofactors(glm::cross(column[1], column[2]), glm::cross(column[2], column[0]),
                             glm::cross(column[0], column[1]));
  return glm::dot(column[0], cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

}  // namespace laver
