#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "image/image.h"
#include "reference/filter.h"
#include "render/options.h"

namespace laver {

/// The variance of each pixel's estimate, sum w L / sum w over the samples that its filter reaches.
///
/// The samples of one pixel's square are independent and equally distributed, those of different
/// squares independent but not alike: what differs between squares is no noise. With m the pixel's
/// value and a_i = w_i (L_i - m), the variance is therefore, to first order in the sum of weights,
/// the sum over the squares of n / (n - 1) (sum a_i^2 - (sum a_i)^2 / n), over (sum w)^2. Samples
/// that are spread more evenly than independent ones have less than this.
class PixelVariances {
 public:
  /// Of the pixels of `core`.
  PixelVariances(const Crop& core, const reference::FilterWeights& weights, unsigned threads)
      : core_(core),
        weights_(weights),
        threads_(threads),
        sums_(static_cast<std::size_t>(core.x1 - core.x0) *
              static_cast<std::size_t>(core.y1 - core.y0)) {}

  struct Sample {
    glm::dvec2 inside;  ///< position in its pixel's square
    glm::dvec3 value;
    bool kept;
  };
  /// A sample of a pixel, by its number.
  using SampleAt = std::function<Sample(int x, int y, std::uint32_t number)>;

  /// Adds samples 0 to n - 1 of the pixels of `from` to those of the pixels of `to` that they
  /// reach.
  void add(const Crop& to, const Crop& from, std::uint32_t n, const SampleAt& at);

  /// Channels variance.R, variance.G, variance.B; 0 where a pixel has no weight. The samples of a
  /// group of one tell nothing; the others stand for them.
  Image image() const;

 private:
  /// Of one pixel, with a_i = w_i L_i. The last two are numbers of samples: of groups that have a
  /// variance, and of all.
  struct Sums {
    glm::dvec3 value{0.0}, squared{0.0}, crossed{0.0};
    double weight = 0.0, weights = 0.0;
    double counted = 0.0, all = 0.0;
  };
  struct Group;

  void addRows(const Crop& to, const Crop& from, std::uint32_t n, const SampleAt& at);
  void addGroup(const Group& group, const Crop& to);

  Crop core_;
  reference::FilterWeights weights_;
  unsigned threads_;
  std::vector<Sums> sums_;
};

}  // namespace laver
