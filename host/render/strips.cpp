#include "render/strips.h"

#include <algorithm>
#include <cstdint>

#include "render/tiling.h"

namespace laver {
namespace {

/// More strips balance the parts no better.
constexpr int kMaxStrips = 16;
/// Rows of a strip per row of the apron: an overhead of two in twenty.
constexpr int kRowsPerApron = 20;

/// Strips of each part: even, so that turns in both directions come in pairs, or one.
int stripsPerPart(int rowsPerPart, int apron) {
  const int count = std::min(rowsPerPart / (kRowsPerApron * std::max(apron, 1)), kMaxStrips);
  return count < 2 ? 1 : count - count % 2;
}

}  // namespace

std::vector<Strip> stripsOf(const Scene& scene, const RenderOptions& options) {
  const Crop core = coreOf(scene.camera, options);
  if (!options.shard) return {{core, 0}};
  const auto [index, parts] = *options.shard;
  const int height = core.y1 - core.y0;
  const int each = stripsPerPart(height / parts, static_cast<int>(apronOf(scene.filter.radius)));
  const auto startOf = [&](int strip) {
    return core.y0 + static_cast<int>(std::int64_t{height} * strip / (std::int64_t{parts} * each));
  };
  std::vector<Strip> strips;
  for (int turn = 0, row = 0; turn < each; ++turn) {
    const int strip = turn * parts + (turn % 2 == 0 ? index : parts - 1 - index);
    const int first = startOf(strip), end = startOf(strip + 1);
    if (!strips.empty() && strips.back().pixels.y1 == first)
      strips.back().pixels.y1 = end;
    else
      strips.push_back({{core.x0, first, core.x1, end}, row});
    row += end - first;
  }
  return strips;
}

std::string textOf(const Shard& shard) {
  return std::to_string(shard.index) + '/' + std::to_string(shard.count);
}

int rowsOf(const std::vector<Strip>& strips) { return strips.back().row + strips.back().rows(); }

const Strip& stripAt(const std::vector<Strip>& strips, int row) {
  return *std::find_if(strips.begin(), strips.end(),
                       [&](const Strip& strip) { return row < strip.row + strip.rows(); });
}

int rowOf(const std::vector<Strip>& strips, int y) {
  const auto found = std::find_if(strips.begin(), strips.end(),
                                  [&](const Strip& strip) { return y < strip.pixels.y1; });
  return found->row + y - found->pixels.y0;
}

std::vector<Strip> bandsIn(const std::vector<Strip>& strips, int rows) {
  std::vector<Strip> bands;
  for (const Strip& strip : strips)
    for (int done = 0; done < strip.rows(); done += rows)
      bands.push_back(strip.part(strip.row + done, std::min(rows, strip.rows() - done)));
  return bands;
}

}  // namespace laver
