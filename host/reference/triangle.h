#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "reference/ray.h"

namespace laver::reference {

using Weights = std::array<double, 3>;
using LongVec = glm::vec<3, long double, glm::defaultp>;

/// A triangle whose corners are sorted, so that copies of it with any order of corners compute
/// the same bits.
struct Triangle {
  Triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, std::uint32_t number);

  /// Barycentric weights of the corners in the order in which they were given.
  Weights asGiven(const Weights& sorted) const;

  /// (corner 1 - corner 0) x (corner 2 - corner 0), of the sorted corners.
  LongVec normal() const;

  std::array<glm::dvec3, 3> corner;
  std::array<std::uint8_t, 3> place;  ///< original index of each sorted corner
  std::uint32_t id;
};

/// The intersection of a line with a triangle.
struct Crossing {
  double t;         ///< ray parameter: a weighted mean of the corners' t
  Weights weights;  ///< barycentric, of the sorted corners; none negative, sum 1
};

/// The exact sign of ax * by - ay * bx, as -1, 0 or 1. Rounding is monotone, so unequal rounded
/// products are ordered like the exact ones; equal ones are ordered by their rounding errors,
/// which fma gives exactly (Dekker's two-product) unless they underflow; then both are 0.
inline int orientation(const glm::dvec3& a, const glm::dvec3& b) {
  double p = a.x * b.y, q = a.y * b.x;
  if (p == q) {
    const double rounded = p;
    p = std::fma(a.x, b.y, -rounded);
    q = std::fma(a.y, b.x, -rounded);
  }
  return (p > q) - (p < q);
}

/// ax * by - ay * bx to about an ulp, with the sign of orientation() (Kahan's difference).
inline double area(const glm::dvec3& a, const glm::dvec3& b) {
  const double p = a.x * b.y, q = a.y * b.x;
  return (p - q) + (std::fma(a.x, b.y, -p) - std::fma(a.y, b.x, -q));
}

/// Where the ray's line crosses the triangle, borders included, at any t of either sign. Both
/// sides count; a triangle seen exactly edge-on does not.
///
/// Watertight: a corner's sheared position depends on the ray and the corner alone, and the three
/// signs are exact for these positions, so the answers for a mesh are those of exact arithmetic on
/// one flat projection of it, moved from the true one by less than 2^-50 of the distances. A point
/// covered by the projection of a connected surface is covered by one of its triangles.
inline std::optional<Crossing> crossing(const Triangle& triangle, const Shear& shear) {
  const glm::dvec3 a = shear(triangle.corner[0]);
  const glm::dvec3 b = shear(triangle.corner[1]);
  const glm::dvec3 c = shear(triangle.corner[2]);
  const int u = orientation(b, c);
  const int v = orientation(c, a);
  if (u * v < 0) return {};
  const int w = orientation(a, b);
  if (v * w < 0 || w * u < 0) return {};
  Weights weights{std::abs(area(b, c)), std::abs(area(c, a)), std::abs(area(a, b))};
  const double sum = weights[0] + weights[1] + weights[2];
  if (!(sum > 0.0)) return {};
  for (double& weight : weights) weight /= sum;
  const double z = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
  return Crossing{z / shear.depth(), weights};
}

/// The ray's t at the triangle's plane, computed in long double and kept between the t of the
/// nearest and the farthest corner. `crossingT` is the t of the crossing, returned when the ray
/// is parallel to the plane.
double planeT(const Triangle& triangle, const Ray& ray, double crossingT);

/// Whether a ray that starts beside the triangle's plane goes towards it.
bool ahead(const Triangle& triangle, const Ray& ray);

/// Whether `a` and `b` lie strictly on different sides of the triangle's plane.
bool separates(const Triangle& triangle, const glm::dvec3& a, const glm::dvec3& b);

}  // namespace laver::reference
