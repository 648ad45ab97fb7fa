#include "stability/exact.h"

#include <array>
#include <cmath>
#include <limits>

namespace laver::test::exact {
namespace {

using Vec = std::array<Quad, 3>;

Vec minus(glm::vec3 a, glm::vec3 b) {
  Vec d;
  for (int i = 0; i < 3; ++i) d[static_cast<std::size_t>(i)] = Quad(a[i]) - Quad(b[i]);
  return d;
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Quad dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec of(glm::vec3 v) { return {Quad(v.x), Quad(v.y), Quad(v.z)}; }
double length(const Vec& v) { return std::sqrt(static_cast<double>(dot(v, v))); }

}  // namespace

bool intersects(glm::vec3 origin, glm::vec3 direction, glm::vec3 lo, glm::vec3 hi) {
  // Bounds of t as fractions with a positive denominator.
  Quad near = 0, nearOver = 1, far = 1, farOver = 0;
  for (int a = 0; a < 3; ++a) {
    Quad d = Quad(direction[a]);
    Quad enter = Quad(lo[a]) - Quad(origin[a]), leave = Quad(hi[a]) - Quad(origin[a]);
    if (d == 0) {
      if (enter > 0 || leave < 0) return false;
      continue;
    }
    if (d < 0) {
      d = -d;
      const Quad swapped = -leave;
      leave = -enter;
      enter = swapped;
    }
    if (enter * nearOver > near * d) {
      near = enter;
      nearOver = d;
    }
    if (leave * farOver < far * d) {
      far = leave;
      farOver = d;
    }
  }
  return near * farOver <= far * nearOver;
}

PlaneHit planeHit(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle) {
  const Vec d = of(direction);
  const Vec a = minus(triangle.a, origin), b = minus(triangle.b, origin);
  const Vec c = minus(triangle.c, origin);
  const Vec n = cross(minus(triangle.b, triangle.a), minus(triangle.c, triangle.a));
  const Quad across = dot(n, d);
  // Signed volumes of the ray's line with each edge.
  const Quad u = dot(d, cross(b, c)), v = dot(d, cross(c, a)), w = dot(d, cross(a, b));
  PlaneHit hit{};
  hit.inside = across != 0 && ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0));
  hit.t = across == 0 ? std::numeric_limits<double>::infinity()
                      : static_cast<double>(dot(n, a) / across);
  hit.cosine = std::abs(static_cast<double>(across)) / (length(n) * length(d));
  return hit;
}

glm::dvec3 weights(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle) {
  const Vec d = of(direction);
  const Vec a = minus(triangle.a, origin), b = minus(triangle.b, origin);
  const Vec c = minus(triangle.c, origin);
  const Quad u = dot(d, cross(b, c)), v = dot(d, cross(c, a)), w = dot(d, cross(a, b));
  const Quad sum = u + v + w;
  return {static_cast<double>(u / sum), static_cast<double>(v / sum), static_cast<double>(w / sum)};
}

glm::dvec3 normal(const shared::Triangle& triangle) {
  const Vec n = cross(minus(triangle.b, triangle.a), minus(triangle.c, triangle.a));
  return glm::normalize(
      glm::dvec3(static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])));
}

double ulps(float value, double truth) {
  const float rounded = std::abs(static_cast<float>(truth));
  const auto ulp = static_cast<double>(std::nextafter(rounded, INFINITY) - rounded);
  return std::abs(static_cast<double>(value) - truth) / ulp;
}

}  // namespace laver::test::exact
