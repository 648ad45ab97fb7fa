#pragma once
#include <string>
#include <vector>

#include "render/options.h"
#include "scene/scene.h"

namespace laver {

/// Rows of a picture: pixels of the film, and the row of the picture at which they begin.
struct Strip {
  Crop pixels;
  int row;

  int rows() const { return pixels.y1 - pixels.y0; }
  /// The rows [first, first + count) of the picture, which lie in this strip.
  Strip part(int first, int count) const {
    const int y = pixels.y0 + first - row;
    return {{pixels.x0, y, pixels.x1, y + count}, first};
  }
};

/// The rows of the film that a render makes, from top to bottom: the core as one strip, or those of
/// a shard.
///
/// Shards have several strips each, since the cost of a film's rows varies: every N-th, and in
/// every other turn in reverse, so that the parts of a film whose cost grows steadily cost the
/// same. Their heights differ by one row at most before adjacent ones are joined. A strip traces
/// the filter's apron above and below it; strips are so high that these rows are at most a tenth of
/// it, if the part has as many rows.
std::vector<Strip> stripsOf(const Scene& scene, const RenderOptions& options);

/// For example 3/8.
std::string textOf(const Shard& shard);

/// Their number of rows.
int rowsOf(const std::vector<Strip>& strips);

/// The strip of a row of the picture.
const Strip& stripAt(const std::vector<Strip>& strips, int row);

/// The row of the picture that a row of the film has.
int rowOf(const std::vector<Strip>& strips, int y);

/// Strips in bands of at most that many rows.
std::vector<Strip> bandsIn(const std::vector<Strip>& strips, int rows);

}  // namespace laver
