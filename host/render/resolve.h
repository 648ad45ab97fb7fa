#pragma once
#include <cstddef>
#include <span>

#include "image/image.h"
#include "render/packed.h"

namespace laver {

/// Weighted means of a film's sums (shared::FilmPixel), into an RGB image from `firstRow` on.
/// Pixels without weight are 0.
void resolve(std::span<const std::byte> film, int firstRow, unsigned threads, Image& image);

/// The same for the layers of pixels' centres, from what film/centres.glsl has left in the film.
void resolveCentres(std::span<const std::byte> film, int firstRow, const Scene& scene,
                    const Normalisation& space, const RenderOptions& options, Image& image);

}  // namespace laver
