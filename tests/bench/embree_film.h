#pragma once
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace laver::bench {

/// One axis of a reconstruction filter, for 16 samples at once.
class LaneFilter {
 public:
  /// Throws Error where the filter reaches further than kMostApron pixels.
  explicit LaneFilter(const Filter& filter);

  static constexpr int kMostApron = 4, kMostSide = 2 * kMostApron + 1;
  int apron() const { return apron_; }
  int side() const { return 2 * apron_ + 1; }
  /// Of samples at `inside` their pixels, for the pixels k - apron() further on.
  void weights(const float (&inside)[16], float (*to)[16]) const;

 private:
  Filter filter_;
  int apron_;
};

/// Sums of weighted radiance and weights.
class EmbreeFilm {
 public:
  EmbreeFilm(const Filter& filter, int width, int height);
  const LaneFilter& filter() const { return filter_; }
  /// Adds sums r, g, b, weight of a rectangle whose top left is at x, y; what lies off the film is
  /// left out.
  void add(int x, int y, int columns, int rows, const std::vector<float>& sums);
  Image image() const;

 private:
  LaneFilter filter_;
  int width_, height_;
  std::vector<double> sums_;
};

}  // namespace laver::bench
