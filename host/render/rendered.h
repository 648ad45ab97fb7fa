#pragma once
#include <cstdint>

#include "image/image.h"

namespace laver {

/// How far a render came. Rows count from the top of the picture.
struct Reached {
  int rows = 0;               ///< rows that hold samples; the pixels below are 0
  int wholeRows = 0;          ///< rows that hold all samples
  std::uint32_t samples = 0;  ///< samples a pixel: the fewest of the rows that hold any
  int unfinished = 0;         ///< pictures and layers beside the first that lack something

  /// Samples a pixel that a row holds, of `wanted`.
  std::uint32_t samplesIn(int row, std::uint32_t wanted) const {
    return row < wholeRows ? wanted : row < rows ? samples : 0;
  }

  /// The next `count` rows, which hold `has` of `wanted` samples a pixel.
  void addRows(int count, std::uint32_t has, std::uint32_t wanted) {
    if (has == 0) return;
    rows += count;
    if (has == wanted) wholeRows += count;
    samples = has;
  }
};

/// What a render returns.
struct Rendered {
  Image image;
  Reached reached;
  std::uint64_t droppedSamples = 0;  ///< of the pixels shown: NaN, infinite or negative

  bool whole() const { return reached.wholeRows == image.height && reached.unfinished == 0; }
};

}  // namespace laver
