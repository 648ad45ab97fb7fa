#pragma once
#include <span>
#include <vector>

#include "lab/chart/methods/rounded_hits.h"
#include "lab/chart/methods/tracer.h"
#include "reference/tree.h"

namespace laver::chart {

/// What exact arithmetic says of float rays and float triangles, and what floats may say instead.
class MethodJudge {
 public:
  /// `bvh` outlives this.
  explicit MethodJudge(const Bvh& bvh);

  /// Adds rays at edges and corners of the triangles that these rays meet, from the same origins.
  std::vector<MethodRay> aimed(std::span<const MethodRay> rays) const;

  /// Finds the truth for rays whose answers are judged below.
  void expect(std::span<const MethodRay> rays);

  /// 99th percentiles over the rays where the answer is the true triangle: of t in ulp, and of the
  /// normal in 2^-24, whichever its side.
  double t99(std::span<const MethodHit> hits) const;
  double normal99(std::span<const MethodHit> hits) const;

  /// Answers that are neither the truth nor explained by rounding (rounded_hits.h).
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
