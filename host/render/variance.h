#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "image/image.h"
#include "reference/filter.h"
#include "render/strips.h"

namespace laver {

/// The variance of each pixel's estimate, sum w L / sum w over the samples that its filter reaches.
///
/// The samples of one pixel's square are independent and equally distributed, those of different
/// squares independent but not alike: what differs between squares is no noise. With m the pixel's
/// value and a_i = w_i (L_i - m), the variance is therefore, to first order in the sum of weights,
/// the sum over the squares of n / (n - 1) (sum a_i^2 - (sum a_i)^2 / n), over (sum w)^2. Samples
/// that are spread more evenly than independent ones have less than this.
///
/// Device and reference share it: it is judged by the spread of many seeds of each.
class PixelVariances {
 public:
  PixelVariances(std::vector<Strip> strips, const reference::FilterWeights& weights,
                 unsigned threads)
      : strips_(std::move(strips)),
        weights_(weights),
        threads_(threads),
        sums_(width() * static_cast<std::size_t>(rowsOf(strips_))) {}

  struct Sample {
    glm::dvec2 inside;  ///< position in its pixel's square
    glm::dvec3 value;
    bool kept;
  };
  /// A sample of a pixel, by its number.
  using SampleAt = std::function<Sample(int x, int y, std::uint32_t number)>;

  /// Adds samples 0 to n - 1 of the pixels of `from` to those of the pixels of `to`, a part of a
  /// strip, that they reach.
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

  std::size_t width() const {
    return static_cast<std::size_t>(strips_[0].pixels.x1 - strips_[0].pixels.x0);
  }

  std::vector<Strip> strips_;  ///< the pixels of the picture
  reference::FilterWeights weights_;
  unsigned threads_;
  std::vector<Sums> sums_;
};

}  // namespace laver
