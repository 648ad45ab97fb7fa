#pragma once
#include <vector>

#include "bvh/bvh.h"
#include "lab/chart/methods/tracer.h"

namespace laver::chart {

/// Which triangles rounding may make the first hit of a float ray, if corners and edges are rounded
/// as in laver's test: cornerShift() and edgeShift() of reference/rounding.h. Both triangles of an
/// edge round alike, so an edge within the sum of these of the ray may lie on its other side, and
/// nothing else may change.
class RoundedHits {
 public:
  /// `bvh` must outlive this object.
  explicit RoundedHits(const Bvh& bvh) : bvh_(bvh) {}

  /// Whether triangle `id` is the first hit at a point that is no farther from the ray than the
  /// largest bound of the edges near it; for NO_HIT, whether such a point has no hit.
  bool explains(const MethodRay& ray, std::uint32_t id) const;

 private:
  const Bvh& bvh_;
};

}  // namespace laver::chart
