#include "lab/chart/films.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace laver::chart {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool usable(const glm::dvec3& v) {
  const auto good = [](double x) { return std::isfinite(x) && x >= 0.0; };
  return good(v.x) && good(v.y) && good(v.z);
}

}  // namespace

Films::Films(int width, int height, std::span<const Filter> filters, unsigned threads)
    : width_(width), height_(height), threads_(threads) {
  for (const Filter& filter : filters) weights_.emplace_back(filter, false);
  const std::size_t pixels = index(width) * index(height);
  values_.resize(pixels);
  places_.resize(pixels);
  kept_.resize(pixels);
  sums_.resize(pixels * filters.size() * 4);
}

void Films::add(const PositionIn& positionIn, const RadianceAt& radianceAt) {
  parallelFor(values_.size(), 256, threads_, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      places_[i] =
          positionIn(static_cast<int>(i % index(width_)), static_cast<int>(i / index(width_)));
      values_[i] = radianceAt(places_[i]);
      kept_[i] = usable(values_[i]) ? 1.0 : 0.0;
      if (kept_[i] == 0.0) values_[i] = glm::dvec3(0.0);
    }
  });
  for (std::size_t f = 0; f < weights_.size(); ++f) gather(f);
}

void Films::gather(std::size_t filter) {
  const reference::FilterWeights& weights = weights_[filter];
  const int reach = weights.reach(), side = 2 * reach + 1;
  byColumn_.resize(values_.size() * index(side));
  byRow_.resize(byColumn_.size());
  const auto rows = index(height_);
  parallelFor(rows, 4, threads_, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first * index(width_); i < last * index(width_); ++i) {
      const int x = static_cast<int>(i % index(width_)), y = static_cast<int>(i / index(width_));
      for (int k = 0; k < side; ++k) {
        byColumn_[i * index(side) + index(k)] = weights(places_[i].x - (x + k - reach + 0.5));
        byRow_[i * index(side) + index(k)] =
            weights(places_[i].y - (y + k - reach + 0.5)) * kept_[i];
      }
    }
  });
  parallelFor(rows, 4, threads_, [&](std::size_t first, std::size_t last) {
    double* sum = &sums_[(filter * rows + first) * index(width_) * 4];
    for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y)
      for (int x = 0; x < width_; ++x, sum += 4)
        for (int v = std::max(y - reach, 0); v <= std::min(y + reach, height_ - 1); ++v)
          for (int u = std::max(x - reach, 0); u <= std::min(x + reach, width_ - 1); ++u) {
            const std::size_t i = index(v) * index(width_) + index(u);
            const double w = byColumn_[i * index(side) + index(x - u + reach)] *
                             byRow_[i * index(side) + index(y - v + reach)];
            for (int c = 0; c < 3; ++c) sum[c] += w * values_[i][c];
            sum[3] += w;
          }
  });
}

Image Films::picture(std::size_t filter) const {
  Image image = rgbImage(width_, height_);
  const double* sum = &sums_[filter * values_.size() * 4];
  for (std::size_t i = 0; i < values_.size(); ++i, sum += 4)
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[i * 3 + c] = sum[3] == 0.0 ? 0.0F : static_cast<float>(sum[c] / sum[3]);
  return image;
}

}  // namespace laver::chart
