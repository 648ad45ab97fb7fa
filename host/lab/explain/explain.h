#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/scene.h"

/// What `laver explain` does, and what the chart and the tests compare pictures by. A float
/// renderer and a double-precision one cannot show the same: near an edge or a shadow's border the
/// one sees what the other misses, and elsewhere values differ by their rounding. Every difference
/// must be one of the two. How far rounding may move a sample is derived in reference/rounding.h;
/// Judge (judge.h) decides by it whether another hit, value or pixel is explained, BoundsOf
/// (bounds.h) how far the values of one hit may be off. What is left is a mistake.
namespace laver {

/// How one quantity of the samples compares, where both renderers meet the same primitive.
struct ExplainedChannel {
  std::string name;
  std::vector<double> ulps;       ///< distances from the reference, one per sample
  std::uint64_t unexplained = 0;  ///< samples beyond their bound
  double worst = 0;               ///< largest of `ulps`, at pixel x, y
  int x = 0, y = 0;
  std::string cause;  ///< of the worst: the largest term of its bound
};

/// One sample per pixel of a scene, by the Vulkan renderer and by the double-precision reference.
struct Explanation {
  /// Samples that differ by a decision.
  struct Decisions {
    std::uint64_t differing = 0, explained = 0;
    std::uint64_t unexplained() const { return differing - explained; }
  };
  std::uint64_t samples = 0;
  Decisions hits;                          ///< another primitive, or none
  Decisions occlusion;                     ///< a light or a direction that one of the two sees
  std::vector<ExplainedChannel> channels;  ///< depth, normal, value
  std::string first;                       ///< the first unexplained difference

  std::uint64_t unexplained() const;
};

/// Renders `scene` and compares. `judged`, with primitives of the same numbers, is what the
/// reference takes for the truth; it is `scene` but for tests. The value is that of the scene's
/// integrator where it looks beyond the first hit. Throws Error(Device).
Explanation explain(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan);

/// The report, lines.
std::string describe(const Explanation& explanation);

}  // namespace laver
