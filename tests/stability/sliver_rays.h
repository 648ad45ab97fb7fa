#pragma once
#include <random>

#include "bvh/bvh.h"
#include "trace/ray_tracer.h"

namespace laver::test {

/// A triangle of a given aspect ratio (longest edge over height), of size about 0.1 in a unit box,
/// and a ray that hits its inside.
struct SliverRay {
  shared::Triangle triangle;
  TestRay ray;
  double cosine;  ///< of incidence, approximately
};

/// `distance` is that of the origin. The cosine is uniform in its range.
SliverRay sliverRay(double aspect, double distance, double minCosine, double maxCosine,
                    std::mt19937& random);

}  // namespace laver::test
