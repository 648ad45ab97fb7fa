#pragma once
#include <optional>
#include <vector>

#include "scene/layers.h"
#include "scene/scene.h"

namespace laver {

class Observer;

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct Crop {
  int x0, y0, x1, y1;
};

/// One of `count` parts of a picture, which other processes render; index from 0.
struct Shard {
  int index, count;
};

/// How to render, apart from what the scene says. Both renderers take it.
struct RenderOptions {
  std::optional<Crop> crop;    ///< default: the whole film; the picture has the crop's size
  std::optional<Shard> shard;  ///< of the core: the picture has only its rows (render/strips.h)
  std::vector<IntegratorUse>
      more;                 ///< further pictures from the same upload, each in channels NAME.*
  Rows<LayerRow> layers;    ///< shown beside the picture
  bool noriCompat = false;  ///< filter weights from Nori's 32-entry table
  double error = 0.0;       ///< adaptive sampling to this error (render/sample_map.h); 0: none
  unsigned threads = 0;     ///< host threads, 0: all
  std::vector<Observer*> observers;  ///< outlive the render
};

/// The pixels of the film that are rendered, by all shards together.
inline Crop coreOf(const Camera& camera, const RenderOptions& options) {
  return options.crop.value_or(Crop{0, 0, camera.width, camera.height});
}

}  // namespace laver
