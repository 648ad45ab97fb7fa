#include "lab/explain/texture_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace laver {
namespace {

constexpr double e = 0x1p-24;

double largestOf(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double valueOf(const Picture& picture, bool raw, std::size_t index, std::size_t channel) {
  if (const auto* image = std::get_if<Image>(&picture))
    return static_cast<double>(image->pixels[3 * index + channel]);
  const double x = std::get<Bitmap>(picture).pixels[index][channel] / 255.0;
  return raw ? x : linearOfSrgb(x);
}

}  // namespace

TextureBounds textureBounds(const Texture& texture, glm::dvec2 uv, glm::dvec2 shift) {
  const double factor = largestOf(texture.colors[0]);
  if (texture.kind == Texture::Kind::Checker)
    return {std::max(factor, largestOf(texture.colors[1])), 0.0};
  if (!texture.image) return {factor, 0.0};
  const Picture& picture = *texture.image;
  const glm::ivec2 size(widthOf(picture), heightOf(picture));
  const glm::dvec2 st = texture.scale * uv + texture.offset;
  // Product and sum, the part of 1, the product with the size and the half pixel.
  const glm::dvec2 moved =
      (glm::abs(texture.scale) * shift + 4.0 * e * (glm::abs(st) + 1.0)) * glm::dvec2(size);
  const glm::dvec2 place((st.x - std::floor(st.x)) * size.x - 0.5,
                         (1.0 - (st.y - std::floor(st.y))) * size.y - 0.5);
  // The pixels that the place may lie between.
  const glm::ivec2 reach(glm::min(moved, glm::dvec2(64.0)) + 1.0);
  const glm::ivec2 low = glm::ivec2(glm::floor(place)) - reach;
  const glm::ivec2 high = glm::ivec2(glm::floor(place)) + 1 + reach;
  const auto around = [](int i, int n) { return (i % n + n) % n; };
  double largest = 0.0, range = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const int index = around(y, size.y) * size.x + around(x, size.x);
        const double value = valueOf(picture, texture.raw, static_cast<std::size_t>(index), c);
        least = std::min(least, value);
        most = std::max(most, value);
      }
    largest = std::max({largest, std::abs(least), std::abs(most)});
    range = std::max(range, most - least);
  }
  // Along each axis the slope is one range a pixel at most.
  return {factor * largest,
          factor * (range * std::min(1.0, moved.x + moved.y) + 8.0 * e * largest)};
}

}  // namespace laver
