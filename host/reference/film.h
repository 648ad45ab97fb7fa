#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

#include "image/image.h"
#include "reference/filter.h"
#include "scene/render_options.h"
#include "scene/scene.h"

namespace laver::reference {

/// What film reconstruction asks for: radiance through a film position in pixels, with the sample's
/// two other numbers.
using RadianceAt = std::function<glm::dvec3(glm::dvec2 film, glm::dvec2 numbers)>;

/// Renders the crop, or the whole film: pixel = sum w value / sum w over the samples within the
/// filter's radius of the pixel's centre on both axes, w the product of the axes' weights, and 0
/// where sum w is 0. Samples come from all pixels of the film, in or out of the crop, and none
/// from beyond it. A pixel's sums run over the sample index, then over the neighbours row by row,
/// in double: its bits depend on neither crop nor threads. Memory does not grow with the samples.
///
/// A sample with a component that is NaN, infinite or, unless it is `signs` that are shown,
/// negative is left out with its weight;
/// `dropped` grows by the number of those that belong to the pixels shown.
/// `reached` becomes how far the render came before options.stop ended it.
/// Throws Error(Usage) if the crop is empty or not inside the film.
Image renderFilm(const Scene& scene, const RenderOptions& options, const RadianceAt& radianceAt,
                 bool signs, std::uint64_t& dropped, Reached& reached);

}  // namespace laver::reference
