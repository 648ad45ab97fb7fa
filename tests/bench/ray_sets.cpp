#include "bench/ray_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace laver::bench {
namespace {

using glm::vec3;

/// Unit normals of triangles by number in file order, oriented by the winding in the file.
std::vector<vec3> normalsOf(const Bvh& bvh) {
  std::vector<vec3> normals;
  for (const shared::Triangle& t : bvh.triangles) {
    normals.resize(std::max<std::size_t>(normals.size(), t.id + 1));
    const glm::dvec3 n = glm::cross(glm::dvec3(t.b - t.a), glm::dvec3(t.c - t.a));
    normals[t.id] = vec3(glm::normalize(n) * (t.flipped != 0 ? -1.0 : 1.0));
  }
  return normals;
}

/// Offset of points from their surface, in normalised space.
constexpr float kOffset = 1e-5F;

}  // namespace

std::vector<TestRay> cameraRays(const Packed& data) {
  const shared::Params& p = data.params;
  const std::uint32_t width = p.filmSize.x, height = p.filmSize.y, rows = height / 8;
  auto stride = static_cast<std::uint32_t>(0.618 * rows);
  while (std::gcd(stride, rows) != 1) ++stride;
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> jitter(0.0F, 1.0F);
  std::vector<TestRay> rays;
  rays.reserve(std::size_t{width} * height);
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < width / 8; ++column)
      for (std::uint32_t i = 0; i < 64; ++i) {
        const std::uint32_t x = column * 8 + (i & 3U) + (i >> 2 & 4U);
        const std::uint32_t y = row * stride % rows * 8 + (i >> 2 & 3U) + (i >> 3 & 4U);
        const float fx =
            static_cast<float>(width) - 2.0F * (static_cast<float>(x) + jitter(engine));
        const float fy =
            static_cast<float>(height) - 2.0F * (static_cast<float>(y) + jitter(engine));
        rays.push_back({p.origin, p.tmin, p.columnX * fx + p.columnY * fy + p.columnZ, p.tmax});
      }
  return rays;
}

std::vector<TestRay> shuffled(std::vector<TestRay> rays) {
  std::shuffle(rays.begin(), rays.end(), std::mt19937(2));
  return rays;
}

std::vector<vec3> litPoints(const Packed& data, std::span<const TestRay> rays,
                            std::span<const TestHit> hits) {
  const auto normals = normalsOf(data.bvh);
  const vec3 light = data.lights.front().position;
  std::vector<vec3> points(rays.size(), vec3(std::numeric_limits<float>::quiet_NaN()));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].id == shared::NO_HIT) continue;
    const vec3 n = normals[hits[i].id], at = rays[i].origin + rays[i].direction * hits[i].t;
    if (glm::dot(n, light - at) > 0.0F && glm::dot(n, rays[i].direction) < 0.0F)
      points[i] = at + n * kOffset;
  }
  return points;
}

std::vector<TestRay> bounced(const Packed& data, std::span<const TestRay> rays,
                             std::span<const TestHit> hits) {
  const auto normals = normalsOf(data.bvh);
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> number(0.0F, 1.0F);
  std::vector<TestRay> out;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].id == shared::NO_HIT) continue;
    vec3 n = normals[hits[i].id];
    if (glm::dot(n, rays[i].direction) > 0.0F) n = -n;
    // The normal plus a point of the unit sphere has a cosine distribution.
    const float z = 2.0F * number(engine) - 1.0F, r = std::sqrt(1.0F - z * z);
    const float angle = 2.0F * std::numbers::pi_v<float> * number(engine);
    const vec3 direction = n + vec3(r * std::cos(angle), r * std::sin(angle), z) * 0.999F;
    out.push_back(
        {rays[i].origin + rays[i].direction * hits[i].t + n * kOffset, 0.0F, direction, 1e10F});
  }
  return out;
}

}  // namespace laver::bench
