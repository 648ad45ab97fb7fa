#pragma once
#include <utility>

#include "pictures/harness.h"

namespace laver::test {

inline constexpr double kError = 0.01;

inline Scene floorScene(int width = 96) { return smallScene("wide-floor.xml", width, 64); }

inline RenderOptions adaptive(double error = kError) {
  RenderOptions options;
  options.error = error;
  return options;
}

/// The picture and the map of samples.
struct Adaptive {
  Image image;
  AdaptiveStats stats;
};

inline Adaptive renderTo(const Scene& scene, const RenderOptions& options,
                         const VulkanOptions& vulkan = onTestDevice()) {
  Stats stats;
  Rendered rendered = Renderer(vulkan).render(scene, options, stats);
  EXPECT_TRUE(rendered.whole());
  return {std::move(rendered.image), std::move(stats.adaptive)};
}

}  // namespace laver::test
