#pragma once
#include "render/stats.h"
#include "scene/scene.h"

namespace laver::bench {

/// Statistics of a render as `laver` does it, on the CPU device with `threads` driver threads. With
/// `allPixels`, pixels whose rays cannot hit any geometry are traced, too.
Stats renderWithLaver(const Scene& scene, unsigned threads, const std::string& traversal = {},
                      bool allPixels = false);

}  // namespace laver::bench
