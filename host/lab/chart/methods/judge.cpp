#include "lab/chart/methods/judge.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/numeric.h"
#include "core/parallel.h"
#include "reference/rounding.h"

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

/// The exact unit normal, up to double rounding. No triangle has area 0. Products of floats are
/// exact in double, and so are most differences.
dvec3 normalOf(const shared::Triangle& t) {
  using LongVec = glm::vec<3, long double, glm::defaultp>;
  const LongVec a(t.a), n = glm::cross(LongVec(t.b) - a, LongVec(t.c) - a);
  return dvec3(n / std::sqrt(glm::dot(n, n)));
}

double errorOfNormal(const dvec3& truth, const glm::vec3& normal) {
  const dvec3 n(normal);
  return std::min(glm::length(n - truth), glm::length(n + truth)) / kUnitRoundoff;
}

}  // namespace

MethodJudge::MethodJudge(const Bvh& bvh)
    : rounded_(bvh), byId_(sortedById(bvh)), tree_(doubleTree(bvh)) {}

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
    const std::size_t number = list.size();
    const glm::vec3 from = corners[number % 3], to = corners[(number + 1) % 3];
    // Corners, midpoints, and points that divide an edge by the golden ratio.
    const float share = number / 3 % 3 == 0 ? 0.0F : number / 3 % 3 == 1 ? 0.5F : 0.381966F;
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
  return percentile(hits, [](const MethodHit& h, const Truth& t) { return ulps(h.t, t.t); });
}

double MethodJudge::normal99(std::span<const MethodHit> hits) const {
  return percentile(
      hits, [](const MethodHit& h, const Truth& t) { return errorOfNormal(t.normal, h.normal); });
}

std::uint64_t MethodJudge::unexplained(std::span<const MethodHit> hits) const {
  std::atomic<std::uint64_t> count = 0;
  parallelFor(hits.size(), 64, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (hits[i].id != truths_[i].id && !rounded_.explains(rays_[i], hits[i].id)) ++count;
  });
  return count;
}

}  // namespace laver::chart
