#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"

namespace laver::chart {

/// As texels: origin + t * direction, tmin <= t <= tmax.
struct MethodRay {
  glm::vec3 origin;
  float tmin;
  glm::vec3 direction;
  float tmax;
};
struct MethodHit {
  glm::vec3 normal;  ///< of either sign
  float t;
  std::uint32_t id;  ///< shared::NO_HIT where nothing is met
};

/// Ways to intersect by their numbers in shared/charted.h.
struct Method {
  std::uint32_t triangles, boxes;
  bool quantised;
};

/// Rays from memory through a tree by shaders/charted/methods.comp.
class MethodTracer {
 public:
  /// `device` as choosePhysicalDevice takes it. Throws Error(Device).
  MethodTracer(const std::string& device, const Bvh& bvh);
  ~MethodTracer();
  MethodTracer(const MethodTracer&) = delete;
  MethodTracer& operator=(const MethodTracer&) = delete;

  /// Takes a method: compiles its kernel.
  void take(const Method& method);
  /// Nearest hits; `seconds` becomes the time of the dispatch, with nothing else.
  std::vector<MethodHit> trace(std::span<const MethodRay> rays, double& seconds);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver::chart
