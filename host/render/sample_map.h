#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "render/options.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace laver {

/// Samples a pixel by cells of shared::CELL x shared::CELL pixels. Cells are the film's, so that a
/// crop and a band have the same as the whole picture.
class SampleMap {
 public:
  /// The cells that the pixels of `area` lie in, and those before them in their blocks, each with
  /// `count`.
  SampleMap(Crop area, std::uint32_t count);

  /// Those cells, in cells.
  Crop cells() const { return cells_; }
  std::uint32_t& cell(int x, int y) { return counts_[index(x, y)]; }
  std::uint32_t cell(int x, int y) const { return counts_[index(x, y)]; }
  std::uint32_t pixel(int x, int y) const { return cell(x / kCell, y / kCell); }

  /// The largest count of the cells that the pixels of `area` lie in.
  std::uint32_t most(Crop area) const;
  /// Samples of the pixels of `area`, counting no more than `most` of each.
  std::uint64_t samplesOf(Crop area, std::uint32_t most) const;
  /// The counts of the cells that a region of pixels lies in, for countAt() of adaptive.glsl.
  std::vector<shared::Count> counts(glm::uvec4 region) const;

  static constexpr int kCell = shared::CELL;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - cells_.y0) *
               static_cast<std::size_t>(cells_.x1 - cells_.x0) +
           static_cast<std::size_t>(x - cells_.x0);
  }

  Crop cells_;
  std::vector<std::uint32_t> counts_;
};

/// The cells that pixels lie in.
Crop cellsOf(Crop pixels);

/// Blocks of so many cells a side have one sample a pixel together or not at all.
inline constexpr int kBlock = 2;

/// The pixels whose pilots decide the counts of all cells that the pixels of `area` lie in.
Crop pilotArea(Crop area, int width, int height);

/// Pilots are pictures of one sample a pixel, each with a seed of its own.
inline constexpr int kPilots = 2;
std::int64_t pilotSeed(std::int64_t seed, int pilot);

/// The most samples that a pixel may get.
inline std::uint32_t mostOf(const Sampler& sampler) {
  return sampler.sampleCount / shared::CELL_STEP * shared::CELL_STEP;
}

/// How many samples a pixel bring the standard error of each cell to `error`, by the variance s^2
/// of the pilots, which are reconstructed as the picture will be: s^2 / error^2, where s^2 is the
/// mean over the cell and the pixels around it of the channel that is largest, and the error is
/// relative to the mean where that is above 1. At least a quarter of what each of the eight
/// neighbours gets, since their features may go on unseen here. 1 in blocks where that has
/// a sixth of the error in all cells; else CELL_STEP to `most`, in multiples of CELL_STEP.
///
/// The counts depend on the pilots alone, and the pilots are not in the picture, so the counts are
/// independent of every sample that they weigh: the mean of a cell's samples is unbiased.
SampleMap decideSamples(std::span<const Image> pilots, Crop area, double error, std::uint32_t most,
                        unsigned threads);

}  // namespace laver
