#pragma once
#include "render/film_state.h"
#include "render/frame.h"
#include "render/observer.h"
#include "render/rendered.h"
#include "render/stats.h"

namespace laver {

/// Input of the loop.
struct RenderTask {
  const Scene& scene;
  const RenderOptions& options;
  const Choices& choices;
  const Packed& packed;
  Observers& observers;
};

/// Statistics of the loop.
struct RenderTimes {
  double readBackSeconds = 0;
  /// Share of the pixels that the scene covers; the others are black and not traced.
  double coverage = 1;
  std::uint32_t bands = 0;
  AdaptiveStats adaptive;
};

/// Renders all pictures of a task. Continues from the sums in `state` and updates it according to
/// state.keep(). Pictures not reached before an observer stops the render are black.
Rendered renderLoop(Frame& frame, const RenderTask& task, FilmState& state, RenderTimes& times);

}  // namespace laver
