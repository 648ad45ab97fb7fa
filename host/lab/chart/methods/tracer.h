#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"

namespace laver::chart {

/// Rays origin + t * direction, tmin <= t <= tmax, as two texels.
struct MethodRay {
  glm::vec3 origin;
  float tmin;
  glm::vec3 direction;
  float tmax;
};
struct MethodHit {
  glm::vec3 normal;  ///< of either sign
  float t;
  std::uint32_t id;  ///< shared::NO_HIT for a miss
};

/// An intersection method, by the numbers of shared/charted.h.
struct Method {
  std::uint32_t triangles, boxes;
  bool quantised;
};

/// Traces rays from memory through a tree with shaders/charted/methods.glsl.
class MethodTracer {
 public:
  /// `device` is selected as by choosePhysicalDevice(). Throws Error(Device).
  MethodTracer(const std::string& device, const Bvh& bvh);
  ~MethodTracer();
  MethodTracer(const MethodTracer&) = delete;
  MethodTracer& operator=(const MethodTracer&) = delete;

  /// Selects a method and compiles its kernel.
  void use(const Method& method);
  /// Nearest hits; sets `seconds` to the time of the dispatch alone.
  std::vector<MethodHit> trace(std::span<const MethodRay> rays, double& seconds);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver::chart
