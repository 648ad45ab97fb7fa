#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "image/image.h"
#include "reference/filter.h"
#include "scene/scene.h"

namespace laver::chart {

/// The whole film in double precision, reconstructed by several filters from the same samples.
class Films {
 public:
  /// Radiance through a film position, and where in its pixel a sample lies; called on all threads.
  using RadianceAt = std::function<glm::dvec3(glm::dvec2)>;
  using PositionIn = std::function<glm::dvec2(int x, int y)>;

  Films(int width, int height, std::span<const Filter> filters, unsigned threads);

  /// Traces one more sample of every pixel and adds it. Samples with a component that is negative
  /// or not finite are left out, as renderers do.
  void add(const PositionIn& positionIn, const RadianceAt& radianceAt);

  /// The picture by a filter: sum w value / sum w, 0 where sum w is 0.
  Image picture(std::size_t filter) const;

  /// All sums, for keeping and going on from: filter by filter, pixel by pixel, r, g, b, weight.
  std::vector<double>& sums() { return sums_; }

 private:
  void gather(std::size_t filter);

  int width_, height_;
  unsigned threads_;
  std::vector<reference::FilterWeights> weights_;
  std::vector<glm::dvec3> values_;  // of the latest samples, one a pixel
  std::vector<glm::dvec2> places_;
  std::vector<double> kept_;  // 0 or 1
  std::vector<double> byColumn_, byRow_;
  std::vector<double> sums_;
};

}  // namespace laver::chart
