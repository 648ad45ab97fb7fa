#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "image/image.h"

namespace laver {

/// Rows that a chunk of a ZIP-compressed EXR file holds.
inline constexpr int kExrZipRows = 16;

/// Rows [y0, y1) as a chunk holds them under ZIP compression: for each row the floats of one
/// channel after the other, in the order `channels` (indices into the image's); deflated, or as
/// they are where that is shorter. Throws std::bad_alloc.
std::vector<std::byte> exrZipChunk(const Image& image, std::span<const std::size_t> channels,
                                   int y0, int y1);

}  // namespace laver
