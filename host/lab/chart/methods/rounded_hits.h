#pragma once
#include <vector>

#include "bvh/bvh.h"
#include "lab/chart/methods/tracer.h"

namespace laver::chart {

/// Which triangles a ray may be said to meet first when corners are rounded as laver's test rounds
/// them (shaders/shared/triangle.h). With p = corner - origin, d the ray's slopes against its
/// largest axis and e = 2^-24, a corner's place beside the ray is off by at most
///   e (|p.x| + 3 |d.x p.z| + |p.x - d.x p.z|)
/// in x and alike in y: the difference, d, the product and the last difference round once each. An
/// edge function of such places has the sign of its rounded products, which moves the edge by
///   e (|ax by| + |ay bx|) / |a - b|.
/// Both triangles of an edge round alike, so an edge that passes the ray within their sum may lie
/// on its other side, and nothing else may change.
class RoundedHits {
 public:
  /// `bvh` outlives this.
  explicit RoundedHits(const Bvh& bvh) : bvh_(bvh) {}

  /// Whether the answer is first at a point that is as near the ray as the largest of the bounds
  /// of the edges that are near it; NO_HIT: whether there is nothing at such a point.
  bool explain(const MethodRay& ray, std::uint32_t id) const;

 private:
  const Bvh& bvh_;
};

}  // namespace laver::chart
