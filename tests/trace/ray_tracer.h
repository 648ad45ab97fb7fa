#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"
#include "vulkan/device.h"
#include "vulkan/kernel.h"

namespace laver::test {

/// A ray origin + t * direction, tmin <= t <= tmax, in normalised space (Normalisation).
struct TestRay {
  glm::vec3 origin;
  float tmin;
  glm::vec3 direction;  ///< of any length but 0
  float tmax;
};

/// The hit of a ray. For a miss, `id` is shared::NO_HIT and t the ray's tmax. u and v are the
/// weights of corners b and c of shared::Triangle, whose corners are sorted; 0 on a sphere.
struct TestHit {
  float t, u, v;
  std::uint32_t id;
};

/// The text of a kernel in tests/trace/.
std::string testText(const std::string& name);

/// Kernels of one device by their text, compiled when they are first asked for.
class TestKernels {
 public:
  const Kernel& get(const Device& device, const Bindings& bindings, const std::string& text);

 private:
  std::map<std::string, Kernel> kernels_;
};

/// Traces arbitrary rays with the traversals of shaders/, in kernels made for tests.
class RayTracer {
 public:
  /// `traversal` is "lane", "packet32" or "packet64"; packets need the features that runsPackets()
  /// checks. Tracers of one device may share `kernels`. Throws Error(Device).
  RayTracer(const Device& device, const Bvh& bvh, const std::string& traversal,
            std::shared_ptr<TestKernels> kernels = std::make_shared<TestKernels>());
  ~RayTracer();

  /// Nearest hits. Packets take rays in blocks of 64 that share the origin of their first ray; the
  /// last block may be shorter.
  std::vector<TestHit> closest(std::span<const TestRay> rays);

  /// Nearest hits of rays with different origins.
  std::vector<TestHit> closestOfAny(std::span<const TestRay> rays);

  /// 1 for each point that is unoccluded from the light, else 0. Points are not offset; the caller
  /// must do that for points on a surface. A point whose x is NaN is not traced: 0.
  std::vector<std::uint32_t> visible(glm::vec3 light, std::span<const glm::vec3> points);

  /// Statistics of the latest call: seconds of dispatches without transfers, and invocations that
  /// exceeded loop iterations or stack. If these are not 0, results are invalid.
  double seconds() const;
  std::uint32_t incomplete() const;

 private:
  std::vector<TestHit> trace(const std::string& query, std::span<const TestRay> rays);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver::test
