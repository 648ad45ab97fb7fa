#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/scene.h"

namespace laver {

/// How one quantity of the samples compares.
struct ExplainedChannel {
  std::string name;
  std::vector<double> ulps;      ///< distance from the reference, one a sample that both hold
  std::uint64_t mismatches = 0;  ///< beyond the stated bound
  std::uint64_t explained = 0;   ///< of these, near a decision of the reference
  double worst = 0;              ///< largest of `ulps`, at pixel x, y
  int x = 0, y = 0;
  std::string cause;  ///< of the worst: the largest term of its bound

  std::uint64_t unexplained() const { return mismatches - explained; }
};

/// One sample a pixel of a scene, by the Vulkan renderer and by the double-precision reference.
/// Bounds and explanations are those of bounds.h, fixed before the render.
struct Explanation {
  std::uint64_t samples = 0;
  std::uint64_t idMismatches = 0, idExplained = 0;          ///< other triangles
  std::uint64_t shadowMismatches = 0, shadowExplained = 0;  ///< a light seen by one of the two
  std::vector<ExplainedChannel> channels;                   ///< depth, normal, radiance
  std::string first;                                        ///< the first unexplained mismatch

  std::uint64_t unexplained() const;
};

/// Renders `scene` and compares. `judged`, with the same meshes' triangles, is what the reference
/// takes for the truth; it is `scene` but for tests. Radiance is compared for direct_whitted.
/// Throws Error(Device), and Error(Usage) for a scene with a sphere.
Explanation explain(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan);

/// The report, lines.
std::string describe(const Explanation& explanation);

}  // namespace laver
