#pragma once
#include <vector>

#include "render/film_state.h"
#include "render/observer.h"
#include "render/passes.h"
#include "render/rendered.h"
#include "render/renderings.h"

namespace laver {

/// What is rendered, and how it is cut.
struct Film {
  const SceneData& data;
  const RenderPlan& plan;
  const Scene& scene;
  const RenderOptions& options;
  Crop core;  ///< the picture's pixels; with adaptive sampling the plan's are more
  Observers& observers;
};

/// All pictures of a scene, one after the other, in one image: bands outside, passes inside. Black
/// where an observer ended the render before. The kernel of the first has been taken. Goes on from
/// the sums in `state`, and leaves there what its Keep says.
Rendered renderPictures(Passes& passes, const Film& film, std::vector<Rendering> pictures,
                        FilmState& state, Stats& stats);

}  // namespace laver
