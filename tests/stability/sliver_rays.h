#pragma once
#include <random>

#include "bvh/bvh.h"
#include "trace/ray_tracer.h"

namespace laver::test {

/// Triangles of one aspect ratio, longest edge by height, of about 0.1 in a unit box, and for each
/// a ray that meets it inside.
struct SliverRay {
  shared::Triangle triangle;
  TestRay ray;
  double cosine;  ///< of the incidence, about
};

/// `distance`: of the origin. The cosine is drawn evenly from its range.
SliverRay sliverRay(double aspect, double distance, double leastCosine, double mostCosine,
                    std::mt19937& random);

}  // namespace laver::test
