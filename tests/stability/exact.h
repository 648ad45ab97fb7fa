#pragma once
#include <glm/glm.hpp>

#include "shared/layout.h"

/// Ground truths of higher precision than what they judge; inputs are the kernels' floats, taken as
/// exact.
namespace laver::stability::exact {

#ifdef __SIZEOF_FLOAT128__
__extension__ using Quad = __float128;  // 113 bits
#else
using Quad = long double;
#endif

/// Whether the ray, t >= 0, has a point in the box, faces included. Differences of floats that are
/// within 2^89 of one another are exact in 113 bits, and so are their products with a float
/// if they are within 2^65; the generators stay within.
bool meets(glm::vec3 origin, glm::vec3 direction, glm::vec3 lo, glm::vec3 hi);

/// Where the ray crosses the triangle's plane, and the cosine of its incidence. Infinite if they
/// are parallel.
struct PlaneHit {
  double t, cosine;
  bool inside;  ///< of the triangle, borders included
};
PlaneHit planeHit(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);

/// Barycentric weights of the corners where the line meets the plane.
glm::dvec3 weights(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);

/// Unit normal of (b - a) x (c - a).
glm::dvec3 normal(const shared::Triangle& triangle);

}  // namespace laver::stability::exact
