#pragma once
#include <cstddef>
#include <span>

#include "image/image.h"
#include "render/packed.h"

namespace laver {

/// Converts a film's sums (shared::FilmPixel) to weighted means, rows of an RGB image from
/// `firstRow` on. Pixels without weight are 0.
void resolve(std::span<const std::byte> film, int firstRow, unsigned threads, Image& image);

/// The same for the layers of pixel centres, from the film that film/centres.glsl has written.
void resolveCentres(std::span<const std::byte> film, int firstRow, const Scene& scene,
                    const Normalisation& space, const RenderOptions& options, Image& image);

}  // namespace laver
