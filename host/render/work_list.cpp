#include "render/work_list.h"

#include <algorithm>

#include "render/tiling.h"

namespace laver {
namespace {

constexpr std::uint32_t kCell = shared::CELL;

/// Work outside of every region.
constexpr shared::Work kNone{0x80000000U, 0x80000000U, 0, 0};

/// The range of the list from `first` on, `together` items per workgroup, filled up to whole rows.
/// Every device supports rows of 65,535 workgroups.
WorkRange rangeFrom(std::size_t first, std::size_t together, std::vector<shared::Work>& list) {
  const std::size_t count = (list.size() - first + together - 1) / together;
  if (count == 0) return {};
  const std::size_t rows = (count + 65534) / 65535, columns = (count + rows - 1) / rows;
  list.resize(first + rows * columns * together, kNone);
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(columns),
          static_cast<std::uint32_t>(rows)};
}

/// Samples of the pass for a pixel whose count is `count`.
std::uint32_t samplesOf(const shared::Pass& pass, std::uint32_t count) {
  return count <= pass.firstSample ? 0 : std::min(count - pass.firstSample, pass.sampleCount);
}

}  // namespace

WorkRange listTracing(const SampleMap& map, const shared::Pass& pass, std::uint32_t shift,
                      const Coverage& needed, std::vector<shared::Work>& list) {
  const std::size_t start = list.size();
  if (shift > 4) return {};
  const std::uint32_t side = 8U >> shift / 2, together = 1U << shift;
  const std::uint32_t cell = std::max(side, kCell);
  // Corners of cells of the film, or of blocks of cells for single samples.
  const std::uint32_t x0 = pass.region.x / cell * cell - pass.region.x;
  const std::uint32_t y0 = pass.region.y / cell * cell - pass.region.y;
  const std::uint32_t columns = (pass.region.z - x0 + cell - 1) / cell;
  const std::uint32_t rows = (pass.region.w - y0 + cell - 1) / cell, stride = rowStride(rows);
  for (std::uint32_t i = 0; i < rows; ++i) {
    const std::uint32_t y =
        y0 + static_cast<std::uint32_t>(std::uint64_t{i} * stride % rows) * cell;
    for (std::uint32_t x = x0; x != x0 + columns * cell; x += cell) {
      const int left = static_cast<int>(pass.region.x + x);
      const int top = static_cast<int>(pass.region.y + y), wide = static_cast<int>(cell);
      if (!needed.intersects({left, top, left + wide, top + wide})) continue;
      const std::uint32_t has = samplesOf(pass, map.pixel(left, top));
      // Earlier samples are in groups four times as large.
      const std::uint32_t first = shift == 4 ? 0 : has / (4 * together) * (4 * together);
      for (std::uint32_t s = first; s + together <= has; s += together)
        for (std::uint32_t v = 0; v < cell; v += side)
          for (std::uint32_t u = 0; u < cell; u += side) list.push_back({x + u, y + v, s, 0});
    }
  }
  return rangeFrom(start, 1, list);
}

WorkRange listGathering(const SampleMap& map, const shared::Pass& pass, std::uint32_t apron,
                        const Coverage& gathered, Coverage& needed,
                        std::vector<shared::Work>& list) {
  constexpr std::uint32_t kColumns = shared::STRIP_COLUMNS, kRows = shared::STRIP_ROWS;
  constexpr std::uint32_t kTogether = shared::GATHER_GROUP / kColumns;
  const std::size_t start = list.size();
  const Crop region = cropOf(pass.region);
  const int reach = static_cast<int>(apron);
  // A strip may begin up to kColumns - 1 columns earlier (film/gather.glsl).
  const std::uint32_t end = pass.core.z + kColumns - 1;
  for (std::uint32_t row = 0; row * kRows < pass.core.w; ++row)
    for (std::uint32_t column = 0; column * kColumns < end; ++column) {
      const int x = static_cast<int>(pass.core.x + column * kColumns);
      const int y = static_cast<int>(pass.core.y + row * kRows);
      const Crop strip{x - static_cast<int>(kColumns) + 1, y, x + static_cast<int>(kColumns),
                       y + static_cast<int>(kRows)};
      if (!gathered.intersects(strip)) continue;
      const Crop taken{std::max(strip.x0 - reach, region.x0), std::max(strip.y0 - reach, region.y0),
                       std::min(strip.x1 + reach, region.x1),
                       std::min(strip.y1 + reach, region.y1)};
      const std::uint32_t samples = samplesOf(pass, map.max(taken));
      if (samples == 0) continue;
      list.push_back({column, row, samples, 0});
      needed.add(taken);
    }
  // Strips of similar sample counts are neighbours, since lanes of a subgroup wait for the slowest.
  std::stable_sort(list.begin() + static_cast<std::ptrdiff_t>(start), list.end(),
                   [](const auto& a, const auto& b) { return a.number > b.number; });
  return rangeFrom(start, kTogether, list);
}

}  // namespace laver
