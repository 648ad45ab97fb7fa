#pragma once
#include <span>
#include <vector>

#include "lab/chart/methods/rounded_hits.h"
#include "lab/chart/methods/tracer.h"
#include "reference/tree.h"

namespace laver::chart {

/// Compares methods' hits with the exact hits of float rays and float triangles.
class MethodJudge {
 public:
  /// `bvh` must outlive this object.
  explicit MethodJudge(const Bvh& bvh);

  /// Rays from the origins of `rays` towards edges and corners of the triangles that these hit.
  std::vector<MethodRay> aimed(std::span<const MethodRay> rays) const;

  /// Computes the exact hits of the rays whose hits are judged below.
  void expect(std::span<const MethodRay> rays);

  /// 99th percentiles of the errors over the rays that hit the right triangle: of t in ulp, and of
  /// the normal, either sign, in units of 2^-24.
  double t99(std::span<const MethodHit> hits) const;
  double normal99(std::span<const MethodHit> hits) const;

  /// Number of hits that are neither exact nor explained by rounding (rounded_hits.h).
  std::uint64_t unexplained(std::span<const MethodHit> hits) const;

 private:
  struct Truth {
    std::uint32_t id = shared::NO_HIT;
    double t = 0;
    glm::dvec3 normal{0.0};
  };
  double percentile(std::span<const MethodHit> hits,
                    double (*error)(const MethodHit&, const Truth&)) const;
  Truth truthOf(const MethodRay& ray) const;

  RoundedHits rounded_;
  std::vector<shared::Triangle> byId_;
  reference::Tree tree_;
  std::vector<MethodRay> rays_;
  std::vector<Truth> truths_;
};

}  // namespace laver::chart
