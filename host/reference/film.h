#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

#include "image/image.h"
#include "reference/filter.h"
#include "reference/sampler.h"
#include "render/observer.h"
#include "render/options.h"
#include "render/rendered.h"
#include "render/variance.h"
#include "scene/scene.h"

namespace laver::reference {

/// Radiance through a film position in pixels, given the sample's other random numbers.
using RadianceAt = std::function<glm::dvec3(glm::dvec2 film, const Numbers& numbers)>;

/// One of the pictures of a render.
struct Picture {
  RadianceAt radianceAt;
  bool isSigned;                        ///< negative values are valid
  std::size_t index, count;             ///< among the pictures of the render
  PixelVariances* variances = nullptr;  ///< to which its samples are added, too
};

/// Renders the crop, or the whole film, or a shard of them. A pixel is sum w value / sum w over the
/// samples within the filter's radius of its centre on both axes, w being the product of the axes'
/// weights; 0 if sum w is 0. Samples of all pixels of the film contribute, inside and outside of
/// the crop. The sums run over the sample index, then over the neighbours row by row, in double, so
/// that the bits depend on neither crop nor threads. Memory does not grow with the number of
/// samples.
///
/// A sample with a component that is NaN, infinite or, unless the picture is signed, negative is
/// dropped with its weight. Throws Error(Usage) if the crop is empty or not inside the film.
Rendered renderFilm(const Scene& scene, const RenderOptions& options, const Picture& picture,
                    Observers& observers);

}  // namespace laver::reference
