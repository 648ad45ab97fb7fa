#include "show/compose.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/compare.h"
#include "image/false_colour.h"
#include "image/srgb.h"

namespace laver {
namespace {

/// A value is displayed as (value - low) * scale.
struct Tone {
  float low = 0.0F, scale = 1.0F;
};

Tone toneOf(const View& view, const Image& image, const ViewLayer& layer) {
  const float exposure = std::exp2(0.5F * static_cast<float>(view.halfStops));
  if (!view.spread) return {0.0F, exposure};
  float low = std::numeric_limits<float>::max(), high = -low;
  for (std::size_t p = 0; p < image.pixels.size(); p += image.channels.size())
    for (const std::size_t c : layer.channels) {
      const float value = image.pixels[p + c];
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  return low < high ? Tone{low, exposure / (high - low)} : Tone{0.0F, exposure};
}

/// For each of `count` pixels of the window, `each` image pixels along one axis; -1 outside the
/// image.
std::vector<int> sampledPixels(int count, int each, double offset, double zoom, int size) {
  std::vector<int> places;
  for (int i = 0; i < count * each; ++i) {
    const double p = std::floor(((i + 0.5) / each - offset) / zoom);
    places.push_back(p >= 0.0 && p < size ? static_cast<int>(p) : -1);
  }
  return places;
}

/// Mean of the added pixels, as a colour.
class Mean {
 public:
  Mean(const ViewLayer& layer, Tone tone) : layer_(layer), tone_(tone) {}

  void clear() { sum_ = {}; }
  void add(const float* pixel) {
    for (std::size_t c = 0; c < layer_.channels.size(); ++c) sum_[c] += pixel[layer_.channels[c]];
  }
  Rgb8 colour(int count) const {
    Rgb8 rgb{};
    for (std::size_t c = 0; c < layer_.channels.size(); ++c)
      rgb[c] = table_((sum_[c] / static_cast<float>(count) - tone_.low) * tone_.scale);
    if (layer_.channels.size() == 1) rgb.fill(rgb[0]);
    return rgb;
  }

 private:
  const ViewLayer& layer_;
  Tone tone_;
  std::array<float, 3> sum_{};
  const SrgbTable& table_ = SrgbTable::shared();
};

/// Largest difference of the added pixels, as a colour.
class Largest {
 public:
  Largest(const ViewLayer& layer, const Image& a, const Image& b) : layer_(layer), a_(a), b_(b) {}

  void clear() { largest_ = 0.0; }
  void add(const float* pixel) {
    const float* other = b_.pixels.data() + (pixel - a_.pixels.data());
    for (const std::size_t c : layer_.channels)
      largest_ = std::max(largest_,
                          distance(static_cast<double>(pixel[c]), static_cast<double>(other[c])));
  }
  Rgb8 colour(int) const { return falseColour(largest_, LogScale{}); }

 private:
  const ViewLayer& layer_;
  const Image &a_, &b_;
  double largest_ = 0.0;
};

template <class Pixel>
void draw(const Image& image, const Placement& placement, Pixel pixel, Bitmap& bitmap) {
  const double zoom = placement.zoom();
  const int each = static_cast<int>(std::clamp(std::ceil(1.0 / zoom), 1.0, 4.0));
  const glm::dvec2 offset = placement.offset();
  const auto columns = sampledPixels(bitmap.width, each, offset.x, zoom, image.width);
  const auto rows = sampledPixels(bitmap.height, each, offset.y, zoom, image.height);
  const auto side = static_cast<std::size_t>(each);
  for (int y = 0; y < bitmap.height; ++y)
    for (int x = 0; x < bitmap.width; ++x) {
      pixel.clear();
      int count = 0;
      for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
          const int u = columns[static_cast<std::size_t>(x) * side + i];
          const int v = rows[static_cast<std::size_t>(y) * side + j];
          if (u < 0 || v < 0) continue;
          const std::size_t at =
              static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(u);
          pixel.add(&image.pixels[at * image.channels.size()]);
          ++count;
        }
      if (count != 0) bitmap.at(x, y) = pixel.colour(count);
    }
}

}  // namespace

Bitmap compose(const Image& a, const Image* b, const ViewLayer& layer, const View& view, int width,
               int height) {
  Bitmap bitmap(width, height, kSurround);
  if (view.mode == View::Mode::Difference) {
    draw(a, view.placement, Largest(layer, a, *b), bitmap);
  } else {
    const Image& image = view.mode == View::Mode::B ? *b : a;
    draw(image, view.placement, Mean(layer, toneOf(view, image, layer)), bitmap);
  }
  return bitmap;
}

}  // namespace laver
