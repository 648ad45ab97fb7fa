#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <optional>

namespace laver {

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct Crop {
  int x0, y0, x1, y1;
};

/// How to render, apart from what the scene says. Both renderers take it.
struct RenderOptions {
  std::optional<Crop> crop;  ///< default: the whole film; the picture has the crop's size
  bool noriCompat = false;   ///< filter weights from Nori's 32-entry table
  unsigned threads = 0;      ///< host threads, 0: all
  std::function<void(double)> progress;  ///< called now and then with the share done, 0 to 1
};

}  // namespace laver
