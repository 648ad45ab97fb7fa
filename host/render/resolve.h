#pragma once
#include <cstddef>
#include <span>

#include "image/image.h"
#include "render/packed.h"

namespace laver {

/// Converts a film's sums (shared::FilmPixel) to weighted means, rows of an RGB image from
/// `firstRow` on. Pixels without weight are 0.
void resolve(std::span<const std::byte> film, int firstRow, unsigned threads, Image& image);

/// A scene and its arrays on the device.
struct PackedScene {
  const Scene& scene;
  const Packed& packed;
};

/// The same for the layers of pixel centres, from the film that film/centres.glsl has written.
void resolveCentres(std::span<const std::byte> film, int firstRow, const PackedScene& rendered,
                    const RenderOptions& options, Image& image);

}  // namespace laver
