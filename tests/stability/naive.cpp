#include "stability/naive.h"

#include <algorithm>
#include <cmath>

#include "bvh/walk.h"

namespace laver::test::naive {

using glm::vec3;

bool moellerTrumbore(vec3 origin, vec3 direction, const shared::Triangle& triangle, float mint,
                     float maxt, TestHit& hit) {
  const vec3 edge1 = triangle.b - triangle.a, edge2 = triangle.c - triangle.a;
  const vec3 p = glm::cross(direction, edge2);
  const float det = glm::dot(edge1, p);
  if (det > -1e-8F && det < 1e-8F) return false;
  const float inverse = 1.0F / det;
  const vec3 s = origin - triangle.a;
  const float u = glm::dot(s, p) * inverse;
  if (u < 0.0F || u > 1.0F) return false;
  const vec3 q = glm::cross(s, edge1);
  const float v = glm::dot(direction, q) * inverse;
  if (v < 0.0F || u + v > 1.0F) return false;
  const float t = glm::dot(edge2, q) * inverse;
  if (!(t >= mint && t <= maxt)) return false;
  hit = {t, u, v, triangle.id};
  return true;
}

bool woopContracted(vec3 origin, vec3 direction, const shared::Triangle& triangle) {
  const shared::Shear s = shared::shearOf(direction);
  const auto sheared = [&](vec3 v) {
    const vec3 p = shared::permute(s, v - origin);
    return glm::vec2(p.x - s.u * p.z, p.y - s.v * p.z);
  };
  const glm::vec2 a = sheared(triangle.a), b = sheared(triangle.b), c = sheared(triangle.c);
  const auto edge = [](glm::vec2 p, glm::vec2 q) { return std::fma(p.x, q.y, -(p.y * q.x)); };
  const float u = edge(c, b), v = edge(a, c), w = edge(b, a);
  return ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) && u + v + w != 0.0F;
}

bool slabs(vec3 origin, vec3 direction, vec3 lo, vec3 hi) {
  const vec3 inverse = 1.0F / direction;
  float near = 0.0F, far = INFINITY;
  for (int a = 0; a < 3; ++a) {
    const float t0 = (lo[a] - origin[a]) * inverse[a], t1 = (hi[a] - origin[a]) * inverse[a];
    near = std::max(near, std::min(t0, t1));
    far = std::min(far, std::max(t0, t1));
  }
  return near <= far;
}

bool intersects(const Bvh& bvh, vec3 origin, vec3 direction, Method method) {
  const auto ray = shared::boxRayOf(origin, direction, shared::shearOf(direction).axis);
  return walk(
      bvh, octantOf(direction),
      [&](const shared::Child& child) {
        if (method == Method::Slabs) return slabs(origin, direction, child.lo, child.hi);
        const auto span = shared::boxSpan(ray, 0.0F, child.lo, child.hi);
        return span.near <= span.far;
      },
      [&](const shared::Triangle& t) {
        TestHit hit;
        return method == Method::WoopContracted
                   ? woopContracted(origin, direction, t)
                   : moellerTrumbore(origin, direction, t, 0.0F, INFINITY, hit);
      });
}

}  // namespace laver::test::naive
