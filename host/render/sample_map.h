#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "render/options.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace laver {

/// Samples per pixel by cells of shared::CELL x shared::CELL pixels. Cells are aligned to the film,
/// so that a crop or a band has the same cells as the whole picture.
class SampleMap {
 public:
  /// Covers the cells of the pixels of `area`, extended to the start of their blocks, each with
  /// `count`.
  SampleMap(Crop area, std::uint32_t count);

  /// The range of cells, in cells.
  Crop cells() const { return cells_; }
  std::uint32_t& cell(int x, int y) { return counts_[index(x, y)]; }
  std::uint32_t cell(int x, int y) const { return counts_[index(x, y)]; }
  std::uint32_t pixel(int x, int y) const { return cell(x / kCell, y / kCell); }

  /// The largest count of the cells of the pixels of `area`.
  std::uint32_t max(Crop area) const;
  /// The sum over the pixels of `area` of their counts, each limited to `max`.
  std::uint64_t samplesOf(Crop area, std::uint32_t max) const;
  /// The counts of the cells of a region of pixels, as countAt() of adaptive.glsl reads them.
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

/// The cells that contain the pixels.
Crop cellsOf(Crop pixels);

/// Blocks of kBlock x kBlock cells: either all their cells have one sample per pixel, or none.
inline constexpr int kBlock = 2;

/// The pixels whose pilots determine the counts of all cells of the pixels of `area`.
Crop pilotArea(Crop area, int width, int height);

/// Pilots are pictures of one sample per pixel, each with its own seed. Paths find much of their
/// light by few samples, of which two pilots see nothing in most cells.
inline constexpr int kPilots = 2, kPilotsOfPaths = 16;
inline int pilotCount(const Scene& scene) {
  return scene.integrator.row->bounces ? kPilotsOfPaths : kPilots;
}
std::int64_t pilotSeed(std::int64_t seed, int pilot);

/// The maximum number of samples per pixel in adaptive sampling.
inline std::uint32_t maxSamplesOf(const Sampler& sampler) {
  return sampler.sampleCount / shared::CELL_STEP * shared::CELL_STEP;
}

/// The maximum number of samples per pixel of a render.
inline std::uint32_t maxSamplesOf(const Scene& scene, const RenderOptions& options) {
  return options.error == 0.0 ? scene.sampler.sampleCount : maxSamplesOf(scene.sampler);
}

/// Chooses samples per pixel that reduce the standard error of each cell to `error`: s^2 / error^2,
/// where s^2 is the variance of the pilots, which are reconstructed like the picture, averaged over
/// the cell and the pixels around it, in the channel where it is largest. The error is relative to
/// the mean where that exceeds 1. A cell gets at least a quarter of the samples of each of its
/// eight neighbours, since their features may extend into it undetected. Counts are 1 in blocks all
/// of whose cells have less than a sixth of the error with one sample, else multiples of CELL_STEP
/// up to `max`.
///
/// The counts depend only on the pilots, which are not part of the picture, so they are independent
/// of every sample that they weight: the mean of a cell's samples is unbiased.
SampleMap decideSamples(std::span<const Image> pilots, Crop area, double error, std::uint32_t max,
                        unsigned threads);

}  // namespace laver
