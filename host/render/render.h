#pragma once
#include "render/film_state.h"
#include "render/frame.h"
#include "render/observer.h"
#include "render/rendered.h"
#include "render/stats.h"

namespace laver {

/// What the loop works on.
struct RenderTask {
  const Scene& scene;
  const RenderOptions& options;
  const Choices& choices;
  const Normalisation& space;
  Observers& observers;
};

/// What the loop notes for statistics.
struct RenderTimes {
  double readBackSeconds = 0;
  double coverage =
      1;  ///< share of the pixels that the scene covers; the others are black untraced
  std::uint32_t bands = 0;
  AdaptiveStats adaptive;
};

/// Renders all pictures of a task. Goes on from the sums in `state`, and leaves there what its Keep
/// says. Pictures that an observer's stop() leaves no time for are black.
Rendered renderLoop(Frame& frame, const RenderTask& task, FilmState& state, RenderTimes& times);

}  // namespace laver
