#pragma once
#include <vector>

#include "bvh/bvh.h"
#include "lab/chart/methods/tracer.h"

namespace laver::chart {

/// Which triangles a float ray may be said to meet first when corners and edges are rounded as
/// laver's test rounds them: cornerShift() and edgeShift() of reference/rounding.h. Both triangles
/// of an edge round alike, so an edge that passes the ray within their sum may lie on its other
/// side, and nothing else may change.
class RoundedHits {
 public:
  /// `bvh` outlives this.
  explicit RoundedHits(const Bvh& bvh) : bvh_(bvh) {}

  /// Whether the answer is first at a point that is as near the ray as the largest of the bounds
  /// of the edges that are near it; NO_HIT: whether there is nothing at such a point.
  bool explains(const MethodRay& ray, std::uint32_t id) const;

 private:
  const Bvh& bvh_;
};

}  // namespace laver::chart
