#pragma once
#include <cstdint>

#include "image/image.h"

namespace laver {

/// Progress of a render that may have been stopped. Rows count from the top of the picture.
struct Reached {
  int rows = 0;               ///< rows that hold samples; the pixels below are 0
  int wholeRows = 0;          ///< rows that hold all samples
  std::uint32_t samples = 0;  ///< per pixel: the minimum over the rows that hold any
  int unfinished = 0;         ///< number of incomplete layers

  /// Samples per pixel of a row, of `wanted`.
  std::uint32_t samplesIn(int row, std::uint32_t wanted) const {
    return row < wholeRows ? wanted : row < rows ? samples : 0;
  }

  /// Adds the next `count` rows, which hold `has` of `wanted` samples per pixel.
  void addRows(int count, std::uint32_t has, std::uint32_t wanted) {
    if (has == 0) return;
    rows += count;
    if (has == wanted) wholeRows += count;
    samples = has;
  }
};

/// The result of a render.
struct Rendered {
  Image image;
  Reached reached;
  std::uint64_t droppedSamples = 0;  ///< in visible pixels: NaN, infinite or negative

  bool whole() const { return reached.wholeRows == image.height && reached.unfinished == 0; }
};

}  // namespace laver
