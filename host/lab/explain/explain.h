#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/scene.h"

/// `laver explain`: compares the float renderer with the double-precision reference. The two cannot
/// agree everywhere: near an edge or a shadow's border one may hit what the other misses (a
/// decision), and elsewhere values differ by their rounding. Every difference must be one of the
/// two; the rest are errors. How far rounding may move a sample is derived in reference/rounding.h;
/// Judge (judge.h) uses it to decide whether another hit, value or pixel is explained, BoundsOf
/// (bounds.h) to bound the values at one hit. The chart and the tests compare pictures by the same
/// classes.
namespace laver {

/// Comparison of one quantity over all samples for which both renderers hit the same primitive.
struct ExplainedChannel {
  std::string name;
  std::vector<double> ulps;       ///< distances from the reference, one per sample
  std::uint64_t unexplained = 0;  ///< samples beyond their bound
  double worst = 0;               ///< largest of `ulps`, at pixel x, y
  int x = 0, y = 0;
  std::string cause;  ///< largest term of the bound of the worst sample
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
  Decisions occlusion;                     ///< a light or direction occluded in one of the two
  std::vector<ExplainedChannel> channels;  ///< depth, normal, value
  std::string first;                       ///< the first unexplained difference

  std::uint64_t unexplained() const;
};

/// Renders `scene` and compares it with the reference's render of `judged`, which has the same
/// primitives in the same order; the two differ only in tests. The value is that of the scene's
/// integrator, if it depends on more than the first hit. Throws Error(Device); Error(Usage) for
/// integrators that follow paths, whose later hits have no bound.
Explanation explain(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan);

/// The report, several lines of text.
std::string describe(const Explanation& explanation);

}  // namespace laver
