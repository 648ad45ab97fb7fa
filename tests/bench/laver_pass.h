#pragma once
#include <functional>

#include "image/image.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace laver::bench {

/// What a render gave: the seconds of tracing of each pass.
struct LaverRender {
  Image image;
  std::vector<double> passes;
  Stats stats;
};

/// Renders as `laver` does, on the CPU device with `threads` of the driver's threads, the traversal
/// of laver's own choice where `traversal` is empty. With `samplesInFlight` above 0 passes hold at
/// most so many samples. `afterPass` is called between passes with their number.
LaverRender renderWithLaver(const Scene& scene, unsigned threads, const std::string& traversal,
                            std::uint64_t samplesInFlight,
                            const std::function<void(std::size_t)>& afterPass = {});

}  // namespace laver::bench
