#pragma once
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"
#include "shared/box.h"
#include "shared/sphere.h"
#include "trace/ray_tracer.h"

namespace laver::test {

/// The text of shaders/shared compiled as C++; one object per set of compiler options.
struct Twin {
  const char* name;
  /// As the queries of RayTracer, but every ray has its own origin.
  void (*closest)(const Bvh& bvh, std::span<const TestRay> rays, TestHit* hits);
  void (*visible)(const Bvh& bvh, glm::vec3 light, std::span<const glm::vec3> points,
                  std::uint32_t* seen);
  shared::Point (*point)(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);
  /// Whether the ray hits the box.
  bool (*box)(glm::vec3 origin, glm::vec3 direction, glm::vec3 lo, glm::vec3 hi);
  /// Whether the ray hits the triangle.
  bool (*inside)(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);
};

/// Unoptimised, optimised, contracted, and with min and max that propagate NaN. The contracted one
/// is absent if the processor has no fused multiply-add.
std::vector<const Twin*> twins();

}  // namespace laver::test
