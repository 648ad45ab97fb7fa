#pragma once
#include "image/image.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace laver::bench {

/// What a render gave.
struct LaverRender {
  Image image;
  Stats stats;
};

/// Renders as `laver` does, on the CPU device with `threads` of the driver's threads; with
/// `everyRay` also what of the film sees nothing.
LaverRender renderWithLaver(const Scene& scene, unsigned threads, const std::string& traversal = {},
                            bool everyRay = false);

}  // namespace laver::bench
