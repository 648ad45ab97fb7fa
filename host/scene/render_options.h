#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/layers.h"

namespace laver {

struct Image;

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct Crop {
  int x0, y0, x1, y1;
};

/// Watches the scene's own picture grow.
struct Watcher {
  /// Rows [firstRow, endRow) of the picture, which is valid during the call, have got new values;
  /// called on the rendering thread. The last call for a row brings its final values.
  std::function<void(const Image& picture, int firstRow, int endRow)> rowsChanged;
  /// Share of the time that calls before the last one for a row may take.
  double share = 0.01;
};

/// How to render, apart from what the scene says. Both renderers take it.
struct RenderOptions {
  std::optional<Crop> crop;         ///< default: the whole film; the picture has the crop's size
  std::vector<IntegratorUse> more;  ///< further pictures from one upload, each in channels NAME.*
  std::vector<Layer> layers;        ///< shown beside the picture
  bool noriCompat = false;          ///< filter weights from Nori's 32-entry table
  double error = 0.0;    ///< adaptive sampling to this error (render/sample_map.h); 0: none
  unsigned threads = 0;  ///< host threads, 0: all
  std::function<void(double)> progress;  ///< called now and then with the share done, 0 to 1
  Watcher watcher;
  std::function<bool()> stop;  ///< asked before each pass: true ends the render there
};

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

}  // namespace laver
