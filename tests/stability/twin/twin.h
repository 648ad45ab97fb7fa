#pragma once
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"
#include "shared/box.h"
#include "shared/sphere.h"
#include "trace/ray_tracer.h"

namespace laver::test {

/// The kernels' text of shaders/shared compiled as C++, one of these for each way of compiling.
struct Twin {
  const char* name;
  /// As RayTracer's queries; every ray has its own origin.
  void (*closest)(const Bvh& bvh, std::span<const TestRay> rays, TestHit* hits);
  void (*visible)(const Bvh& bvh, glm::vec3 light, std::span<const glm::vec3> points,
                  std::uint32_t* seen);
  shared::Point (*point)(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);
  /// Does the line from the origin on meet the box?
  bool (*box)(glm::vec3 origin, glm::vec3 direction, glm::vec3 lo, glm::vec3 hi);
  /// Does it meet the triangle?
  bool (*inside)(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);
};

/// Unoptimised, optimised, contracted, and with min and max that keep NaN. The contracted one is
/// absent where the processor has no fused multiply-add.
std::vector<const Twin*> twins();

}  // namespace laver::test
