#include "render/sample_map.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "render/tiling.h"

namespace laver {
namespace {

constexpr int kCell = SampleMap::kCell;
/// Margin of pixels around a cell that the cell's samples affect, whose noise therefore counts.
constexpr int kAround = 1;
/// A cell gets at least this share of a neighbour's samples.
constexpr std::uint32_t kShareOfNeighbours = 4;
/// A single sample per pixel suffices where its error is below a sixth of the target. Such areas
/// can make up most of a picture, so their noise, which four samples of `sobol` would remove, must
/// stay well below the target.
constexpr double kOne = 1.0 / 36.0;

/// Mean over the pixels of `window` of the pilots' variance, relative to the squared mean where
/// that exceeds 1, in the channel where it is largest.
double varianceIn(std::span<const Image> pilots, Crop area, Crop window) {
  const auto count = static_cast<double>(pilots.size());
  double variance[3] = {}, mean[3] = {};
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0, squares = 0;
        for (const Image& pilot : pilots)
          sum += static_cast<double>(pilot.at(x - area.x0, y - area.y0, c));
        for (const Image& pilot : pilots) {
          const double away =
              static_cast<double>(pilot.at(x - area.x0, y - area.y0, c)) - sum / count;
          squares += away * away;
        }
        mean[c] += sum / count;
        variance[c] += squares / (count - 1);
      }
  const double pixels = (window.x1 - window.x0) * (window.y1 - window.y0);
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    const double white = std::max(1.0, mean[c] / pixels);
    largest = std::max(largest, variance[c] / pixels / (white * white));
  }
  return largest;
}

std::uint32_t rounded(double samples, std::uint32_t max) {
  if (samples <= kOne) return 1;
  const double steps = std::ceil(std::min(samples, static_cast<double>(max)) / shared::CELL_STEP);
  return std::clamp(static_cast<std::uint32_t>(steps) * shared::CELL_STEP, shared::CELL_STEP, max);
}

int down(int x, int step) { return x / step * step; }

/// Extends pixels to the left and upper borders of their blocks.
Crop fromBlocks(Crop pixels) {
  return {down(pixels.x0, kBlock * kCell), down(pixels.y0, kBlock * kCell), pixels.x1, pixels.y1};
}

/// Raises single samples in blocks that have other cells with more.
void evenBlocks(SampleMap& map) {
  const Crop cells = map.cells();
  for (int y = cells.y0; y < cells.y1; y += kBlock)
    for (int x = cells.x0; x < cells.x1; x += kBlock) {
      const int right = std::min(x + kBlock, cells.x1), below = std::min(y + kBlock, cells.y1);
      std::uint32_t max = 0;
      for (int v = y; v < below; ++v)
        for (int u = x; u < right; ++u) max = std::max(max, map.cell(u, v));
      for (int v = y; v < below; ++v)
        for (int u = x; u < right; ++u)
          if (max > 1) map.cell(u, v) = std::max(map.cell(u, v), shared::CELL_STEP);
    }
}

}  // namespace

Crop cellsOf(Crop pixels) {
  return {pixels.x0 / kCell, pixels.y0 / kCell, (pixels.x1 + kCell - 1) / kCell,
          (pixels.y1 + kCell - 1) / kCell};
}

SampleMap::SampleMap(Crop area, std::uint32_t count)
    : cells_(cellsOf(fromBlocks(area))),
      counts_(static_cast<std::size_t>(cells_.x1 - cells_.x0) *
                  static_cast<std::size_t>(cells_.y1 - cells_.y0),
              count) {}

std::uint32_t SampleMap::max(Crop area) const {
  const Crop c = cellsOf(area);
  std::uint32_t result = 0;
  for (int y = c.y0; y < c.y1; ++y)
    result = std::max(
        result, *std::max_element(&counts_[index(c.x0, y)], &counts_[index(c.x1 - 1, y)] + 1));
  return result;
}

std::uint64_t SampleMap::samplesOf(Crop area, std::uint32_t max) const {
  std::uint64_t sum = 0;
  for (int y = area.y0; y < area.y1; ++y)
    for (int x = area.x0; x < area.x1; ++x) sum += std::min(pixel(x, y), max);
  return sum;
}

std::vector<shared::Count> SampleMap::counts(glm::uvec4 region) const {
  const Crop c = cellsOf(cropOf(region));
  std::vector<shared::Count> result;
  for (int y = c.y0; y < c.y1; ++y)
    for (int x = c.x0; x < c.x1; ++x) result.push_back({cell(x, y), 0, 0, 0});
  return result;
}

Crop pilotArea(Crop area, int width, int height) {
  // The neighbours of the cells of its blocks, and the margin around those.
  const Crop begun = fromBlocks(area);
  const int margin = kCell + kAround, side = kBlock * kCell;
  return {std::max(begun.x0 - margin, 0), std::max(begun.y0 - margin, 0),
          std::min(down(area.x1 + side - 1, side) + margin, width),
          std::min(down(area.y1 + side - 1, side) + margin, height)};
}

std::int64_t pilotSeed(std::int64_t seed, int pilot) {
  // Far from consecutive seeds of users, and from the blocks that `independent` adds to its seed.
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(seed) +
                                   0x9e3779b97f4a7c15U * static_cast<std::uint64_t>(pilot + 1));
}

SampleMap decideSamples(std::span<const Image> pilots, Crop area, double error, std::uint32_t max,
                        unsigned threads) {
  SampleMap wanted(area, 1);
  const Crop cells = wanted.cells();
  const auto rows = static_cast<std::size_t>(cells.y1 - cells.y0);
  parallelFor(rows, 4, threads, [&](std::size_t begin, std::size_t end) {
    for (int y = cells.y0 + static_cast<int>(begin); y < cells.y0 + static_cast<int>(end); ++y)
      for (int x = cells.x0; x < cells.x1; ++x) {
        const Crop window{std::max(x * kCell - kAround, area.x0),
                          std::max(y * kCell - kAround, area.y0),
                          std::min((x + 1) * kCell + kAround, area.x1),
                          std::min((y + 1) * kCell + kAround, area.y1)};
        wanted.cell(x, y) = rounded(varianceIn(pilots, area, window) / (error * error), max);
      }
  });
  SampleMap result = wanted;
  for (int y = cells.y0; y < cells.y1; ++y)
    for (int x = cells.x0; x < cells.x1; ++x)
      for (int v = std::max(y - 1, cells.y0); v < std::min(y + 2, cells.y1); ++v)
        for (int u = std::max(x - 1, cells.x0); u < std::min(x + 2, cells.x1); ++u)
          if (wanted.cell(u, v) > kShareOfNeighbours)
            result.cell(x, y) = std::max(
                result.cell(x, y), rounded(wanted.cell(u, v) / double{kShareOfNeighbours}, max));
  evenBlocks(result);
  return result;
}

}  // namespace laver
