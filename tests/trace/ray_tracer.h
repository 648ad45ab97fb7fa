#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"
#include "vulkan/device.h"
#include "vulkan/kernel.h"

namespace laver::test {

/// origin + t * direction, tmin <= t <= tmax, in the kernels' space (Normalisation).
struct TestRay {
  glm::vec3 origin;
  float tmin;
  glm::vec3 direction;  ///< of any length but 0
  float tmax;
};

/// `id` is shared::NO_HIT and t the ray's tmax where nothing was met. u and v are the weights of
/// the corners b and c of the shared::Triangle of that id, whose corners are sorted; 0 on a sphere.
struct TestHit {
  float t, u, v;
  std::uint32_t id;
};

/// The text of a kernel in tests/trace/.
std::string testText(const std::string& name);

/// Rays of a test's choice through the traversals of shaders/, in kernels of the tests' own.
class RayTracer {
 public:
  /// `traversal` is "lane", or "packet32" or "packet64", which need what bestTraversal says. Throws
  /// Error(Device).
  RayTracer(const Device& device, const Bvh& bvh, const std::string& traversal);
  ~RayTracer();

  /// Nearest hits. By packet, rays come in blocks of 64, each with one origin: that of its first
  /// ray counts; the last block may be shorter.
  std::vector<TestHit> closest(std::span<const TestRay> rays);

  /// The same of rays with origins of their own.
  std::vector<TestHit> closestOfAny(std::span<const TestRay> rays);

  /// 1 for each point with nothing between it and the light, else 0. Points count as they are:
  /// those of a surface are moved off it by the caller. A point whose x is NaN is not traced: 0.
  std::vector<std::uint32_t> visible(glm::vec3 light, std::span<const glm::vec3> points);

  /// Of the latest call: seconds of dispatches alone, transfers left out, and invocations that ran
  /// out of loop iterations or of stack. Where those are not 0, results mean nothing.
  double seconds() const;
  std::uint32_t incomplete() const;

 private:
  std::vector<TestHit> trace(const Kernel& kernel, std::span<const TestRay> rays);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver::test
