#pragma once
#include <glm/glm.hpp>

#include "shared/layout.h"

/// Ground truth in higher precision. Inputs are the kernels' floats, taken as exact.
namespace laver::test::exact {

#ifdef __SIZEOF_FLOAT128__
__extension__ using Quad = __float128;  // 113 bits
#else
using Quad = long double;
#endif

/// Whether the ray with t >= 0 has a point in the box, faces included. Differences of floats within
/// 2^89 of each other are exact in 113 bits, and so are their products with a float if they are
/// within 2^65; the generators stay within that.
bool intersects(glm::vec3 origin, glm::vec3 direction, glm::vec3 lo, glm::vec3 hi);

/// Where the ray crosses the triangle's plane, and the cosine of incidence. Infinite if they are
/// parallel.
struct PlaneHit {
  double t, cosine;
  bool inside;  ///< of the triangle, borders included
};
PlaneHit planeHit(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);

/// Barycentric weights of the corners at the point where the line crosses the plane.
glm::dvec3 weights(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);

/// Unit normal of (b - a) x (c - a).
glm::dvec3 normal(const shared::Triangle& triangle);

/// Distance of a float from the true value, in ulp of a float of that size.
double ulps(float value, double truth);

}  // namespace laver::test::exact
