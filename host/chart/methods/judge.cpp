#include "chart/methods/judge.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>

#include "chart/numbers.h"
#include "core/parallel.h"

namespace laver::chart {
namespace {

using glm::dvec3;

reference::Tree doubleTree(const Bvh& bvh) {
  std::vector<reference::Triangle> triangles;
  for (const shared::Triangle& t : bvh.triangles) triangles.emplace_back(t.a, t.b, t.c, t.id);
  return reference::Tree(std::move(triangles));
}

std::vector<shared::Triangle> sortedById(const Bvh& bvh) {
  std::vector<shared::Triangle> list(bvh.triangles.begin(), bvh.triangles.end());
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return list;
}

/// Neither is zero. Products of floats are exact in double, and so are most differences.
dvec3 normalOf(const shared::Triangle& t) {
  using LongVec = glm::vec<3, long double, glm::defaultp>;
  const LongVec a(t.a), n = glm::cross(LongVec(t.b) - a, LongVec(t.c) - a);
  return dvec3(n / std::sqrt(glm::dot(n, n)));
}

double ulps(float value, double truth) {
  const float rounded = std::abs(static_cast<float>(truth));
  return std::abs(static_cast<double>(value) - truth) /
         static_cast<double>(std::nextafter(rounded, INFINITY) - rounded);
}

double errorOfT(double truth, float t) { return ulps(t, truth); }

double errorOfNormal(const dvec3& truth, const glm::vec3& normal) {
  const dvec3 n(normal);
  return std::min(glm::length(n - truth), glm::length(n + truth)) / 0x1p-24;
}

/// Where a triangle is within `pad` of a ray's line, sideways: the ray's t beside its nearest
/// point.
std::optional<double> nearRay(const shared::Triangle& triangle, const reference::Ray& ray,
                              double pad) {
  const reference::Triangle t(triangle.a, triangle.b, triangle.c, triangle.id);
  const reference::Shear shear(ray);
  if (const auto crossing = reference::crossing(t, shear)) return crossing->t;
  double nearest = pad, depth = 0;
  bool found = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 a = shear(t.corner[i]), b = shear(t.corner[(i + 1) % 3]);
    const glm::dvec2 from(a), along = glm::dvec2(b) - from;
    const double share =
        std::clamp(-glm::dot(from, along) / std::max(glm::dot(along, along), 1e-300), 0.0, 1.0);
    const double distance = glm::length(from + share * along);
    if (distance > nearest) continue;
    nearest = distance;
    depth = std::lerp(a.z, b.z, share);
    found = true;
  }
  if (!found) return {};
  return depth / shear.depth();
}

}  // namespace

MethodJudge::MethodJudge(const Bvh& bvh) : byId_(sortedById(bvh)), tree_(doubleTree(bvh)) {}

MethodJudge::Truth MethodJudge::truthOf(const MethodRay& ray) const {
  const auto hit = tree_.closest({ray.origin, ray.direction}, static_cast<double>(ray.tmin),
                                 static_cast<double>(ray.tmax));
  if (!hit) return {};
  const auto found = std::lower_bound(byId_.begin(), byId_.end(), hit->triangle->id,
                                      [](const auto& t, std::uint32_t id) { return t.id < id; });
  using LongVec = glm::vec<3, long double, glm::defaultp>;
  const LongVec a(found->a), n = glm::cross(LongVec(found->b) - a, LongVec(found->c) - a);
  const long double across = glm::dot(n, LongVec(ray.direction));
  const long double t = glm::dot(n, a - LongVec(ray.origin)) / across;
  return {hit->triangle->id, across == 0 ? hit->t : static_cast<double>(t), normalOf(*found)};
}

std::vector<MethodRay> MethodJudge::aimed(std::span<const MethodRay> rays) const {
  std::vector<MethodRay> list;
  for (const MethodRay& ray : rays) {
    const Truth truth = truthOf(ray);
    if (truth.id == shared::NO_HIT) continue;
    const auto t = *std::lower_bound(byId_.begin(), byId_.end(), truth.id,
                                     [](const auto& x, std::uint32_t id) { return x.id < id; });
    const glm::vec3 corners[] = {t.a, t.b, t.c};
    const std::size_t turn = list.size();
    const glm::vec3 from = corners[turn % 3], to = corners[(turn + 1) % 3];
    // Corners, midpoints, and points between by the golden ratio.
    const float share = turn / 3 % 3 == 0 ? 0.0F : turn / 3 % 3 == 1 ? 0.5F : 0.381966F;
    list.push_back({ray.origin, 0.0F, from + (to - from) * share - ray.origin, 1e30F});
  }
  return list;
}

void MethodJudge::expect(std::span<const MethodRay> rays) {
  rays_.assign(rays.begin(), rays.end());
  truths_.resize(rays.size());
  parallelFor(rays.size(), 256, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) truths_[i] = truthOf(rays_[i]);
  });
}

double MethodJudge::percentile(std::span<const MethodHit> hits,
                               double (*error)(const MethodHit&, const Truth&)) const {
  std::vector<double> errors;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (hits[i].id == truths_[i].id && hits[i].id != shared::NO_HIT)
      errors.push_back(error(hits[i], truths_[i]));
  return quantile(std::move(errors), 0.99);
}

double MethodJudge::t99(std::span<const MethodHit> hits) const {
  return percentile(hits, [](const MethodHit& h, const Truth& t) { return errorOfT(t.t, h.t); });
}

double MethodJudge::normal99(std::span<const MethodHit> hits) const {
  return percentile(
      hits, [](const MethodHit& h, const Truth& t) { return errorOfNormal(t.normal, h.normal); });
}

std::uint64_t MethodJudge::unexcused(std::span<const MethodHit> hits) const {
  std::atomic<std::uint64_t> count = 0;
  parallelFor(hits.size(), 64, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (hits[i].id != truths_[i].id && !excused(i, hits[i].id)) ++count;
  });
  return count;
}

/// A ray may pass a triangle by 16 e A sideways (shared/box.h: e = 2^-24, A = max |origin| + 1).
/// The answer stands if its triangle lies that near the ray, at a depth where one of 48 rays around
/// this one, near and at that distance, meets something first: to 1e-4, which is that distance seen
/// under a cosine of 0.03. No hit stands where one of them meets nothing.
bool MethodJudge::excused(std::size_t ray, std::uint32_t id) const {
  const MethodRay& r = rays_[ray];
  const dvec3 d(r.direction), o(r.origin);
  const double reach = std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) + 1.0;
  const double pad = 16.0 * 0x1p-24 * reach;
  const double at = truths_[ray].id == shared::NO_HIT ? 1.0 : truths_[ray].t;
  const dvec3 side = glm::normalize(
      glm::cross(d, std::abs(d.x) < 0.5 * glm::length(d) ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  const dvec3 other = glm::normalize(glm::cross(d, side));
  const auto wanted = std::lower_bound(byId_.begin(), byId_.end(), id,
                                       [](const auto& t, std::uint32_t x) { return t.id < x; });
  const std::optional<double> own =
      id == shared::NO_HIT ? std::nullopt : nearRay(*wanted, {o, d}, pad);
  if (id != shared::NO_HIT && !own) return false;
  for (int i = 0; i < 48; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i % 24) / 24.0;
    const double away = pad / at * (i < 24 ? 1.0 : 0.3);
    const reference::Ray moved{o, d + away * (std::cos(angle) * side + std::sin(angle) * other)};
    const auto hit = tree_.closest(moved, static_cast<double>(r.tmin) * (1.0 - 1e-6),
                                   static_cast<double>(r.tmax) * (1.0 + 1e-6));
    if (own ? hit && std::abs(hit->t - *own) <= 1e-4 * hit->t : !hit) return true;
  }
  return false;
}

}  // namespace laver::chart
