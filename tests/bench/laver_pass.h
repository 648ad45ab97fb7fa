#pragma once
#include "render/stats.h"
#include "scene/scene.h"

namespace laver::bench {

/// Figures of a render as `laver` does it, on the CPU device with `threads` of the driver's
/// threads. With `allPixels`, pixels whose rays cannot hit any geometry are traced too.
Stats renderWithLaver(const Scene& scene, unsigned threads, const std::string& traversal = {},
                      bool allPixels = false);

}  // namespace laver::bench
