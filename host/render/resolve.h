#pragma once
#include <cstddef>
#include <span>

#include "image/image.h"

namespace laver {

/// The picture's rows from `firstRow` on, from a band's sums (shared::FilmPixel each): rgb /
/// weight, 0 where no weight fell.
void resolve(std::span<const std::byte> film, int firstRow, Image& image, unsigned threads);

}  // namespace laver
