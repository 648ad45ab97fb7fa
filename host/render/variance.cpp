#include "render/variance.h"

#include <algorithm>

#include "core/parallel.h"
#include "scene/layers.h"

namespace laver {

/// The samples of one pixel's square that were kept, and their weights on both axes for the pixels
/// at -reach to reach.
struct PixelVariances::Group {
  int x = 0, y = 0, reach = 0;
  int above = 0;  ///< rows of the film above `to` that the picture does not have
  std::vector<glm::dvec3> values{};
  std::vector<double> across{}, down{};

  std::size_t span() const { return 2 * static_cast<std::size_t>(reach) + 1; }
};

void PixelVariances::add(const Crop& to, const Crop& from, std::uint32_t n, const SampleAt& at) {
  const auto rows = static_cast<std::size_t>(std::max(to.y1 - to.y0, 0));
  parallelFor(rows, 16, threads_, [&](std::size_t begin, std::size_t end) {
    addRows({to.x0, to.y0 + static_cast<int>(begin), to.x1, to.y0 + static_cast<int>(end)}, from, n,
            at);
  });
}

void PixelVariances::addRows(const Crop& to, const Crop& from, std::uint32_t n,
                             const SampleAt& at) {
  Group group;
  if (to.y0 == to.y1) return;
  const int reach = group.reach = weights_.reach();
  group.above = to.y0 - rowOf(strips_, to.y0);
  for (int y = std::max(from.y0, to.y0 - reach); y < std::min(from.y1, to.y1 + reach); ++y) {
    for (int x = std::max(from.x0, to.x0 - reach); x < std::min(from.x1, to.x1 + reach); ++x) {
      group.x = x;
      group.y = y;
      group.values.clear();
      group.across.clear();
      group.down.clear();
      for (std::uint32_t i = 0; i < n; ++i) {
        const Sample sample = at(x, y, i);
        if (!sample.kept) continue;
        group.values.push_back(sample.value);
        for (int k = -reach; k <= reach; ++k) {
          group.across.push_back(weights_(sample.inside.x - 0.5 - k));
          group.down.push_back(weights_(sample.inside.y - 0.5 - k));
        }
      }
      addGroup(group, to);
    }
  }
}

void PixelVariances::addGroup(const Group& group, const Crop& to) {
  const int reach = group.reach;
  const std::size_t n = group.values.size(), span = group.span();
  const double count = static_cast<double>(n), factor = n > 1 ? count / (count - 1.0) : 0.0;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const int x = group.x + dx, y = group.y + dy;
      if (x < to.x0 || x >= to.x1 || y < to.y0 || y >= to.y1) continue;
      glm::dvec3 a(0.0), aa(0.0), aw(0.0);
      double w = 0.0, ww = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        const double weight = group.across[i * span + static_cast<std::size_t>(dx + reach)] *
                              group.down[i * span + static_cast<std::size_t>(dy + reach)];
        const glm::dvec3 weighted = weight * group.values[i];
        w += weight;
        ww += weight * weight;
        a += weighted;
        aa += weighted * weighted;
        aw += weight * weighted;
      }
      Sums& sums = sums_[static_cast<std::size_t>(y - group.above) * width() +
                         static_cast<std::size_t>(x - strips_[0].pixels.x0)];
      sums.value += a;
      sums.weight += w;
      sums.all += count;
      if (n < 2) continue;
      sums.counted += count;
      sums.squared += factor * (aa - a * a / count);
      sums.crossed += factor * (aw - a * w / count);
      sums.weights += factor * (ww - w * w / count);
    }
  }
}

Image PixelVariances::image() const {
  Image image = blackImage(static_cast<int>(width()), rowsOf(strips_), layers::variance.channels);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Sums& s = sums_[i];
    if (s.weight == 0.0 || s.counted == 0.0) continue;
    const glm::dvec3 mean = s.value / s.weight;
    const glm::dvec3 sum = s.squared - 2.0 * mean * s.crossed + mean * mean * s.weights;
    for (int c = 0; c < 3; ++c)
      image.pixels[3 * i + static_cast<std::size_t>(c)] =
          static_cast<float>(std::max(sum[c], 0.0) * (s.all / s.counted) / (s.weight * s.weight));
  }
  return image;
}

}  // namespace laver
