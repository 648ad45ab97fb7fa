#include "lab/chart/pictures.h"

#include <algorithm>
#include <cmath>

#include "image/false_colour.h"
#include "image/io.h"
#include "image/srgb.h"

namespace laver::chart {
namespace {

constexpr LogScale kScale{-4, 0};

std::string base64(const std::vector<std::byte>& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint32_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string dataUri(const Bitmap& bitmap) {
  return "data:image/png;base64," + base64(encodePng(bitmap));
}

/// Calls paint(x, y, first column, end, first row, end) for each pixel of the smaller picture.
template <class Paint>
Bitmap shrink(const Image& image, const Paint& paint) {
  const int width = std::min(image.width, kThumbnail);
  const int height = std::max(1, image.height * width / image.width);
  Bitmap small(width, height, {});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      small.at(x, y) =
          paint(x * image.width / width, std::max((x + 1) * image.width / width, 1),
                y * image.height / height, std::max((y + 1) * image.height / height, 1));
  return small;
}

/// Mean over the pixels of a rectangle of value(pixel index).
template <class Value>
double mean(const Image& image, int x0, int x1, int y0, int y1, const Value& value) {
  double sum = 0.0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      sum += value((static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(x)) *
                   3);
  return sum / ((x1 - x0) * (y1 - y0));
}

}  // namespace

std::string thumbnailOf(const Image& image) {
  return dataUri(shrink(image, [&](int x0, int x1, int y0, int y1) {
    Rgb8 colour{};
    for (std::size_t c = 0; c < 3; ++c)
      colour[c] = srgb8(static_cast<float>(mean(image, x0, x1, y0, y1, [&](std::size_t i) {
        return static_cast<double>(image.pixels[i + c]);
      })));
    return colour;
  }));
}

std::string errorMapOf(const Image& image, const Image& truth) {
  return dataUri(shrink(image, [&](int x0, int x1, int y0, int y1) {
    return falseColour(std::sqrt(mean(image, x0, x1, y0, y1,
                                      [&](std::size_t i) {
                                        double squares = 0.0;
                                        for (std::size_t c = i; c < i + 3; ++c) {
                                          const double d = static_cast<double>(image.pixels[c]) -
                                                           static_cast<double>(truth.pixels[c]);
                                          squares += d * d / 3.0;
                                        }
                                        return squares;
                                      })),
                       kScale);
  }));
}

}  // namespace laver::chart
