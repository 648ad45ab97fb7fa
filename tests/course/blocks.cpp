#include "course/blocks.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace laver::test {
namespace {

constexpr int kBlock = 8;

double valueAt(const Image& image, int x, int y, int channel) {
  const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x);
  return static_cast<double>(
      image.pixels[pixel * image.channels.size() + static_cast<std::size_t>(channel)]);
}

double meanOf(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) sum += valueAt(image, x, y, c);
  return sum / (3.0 * image.width * image.height);
}

double blockDifference(const Image& a, const Image& b) {
  double squares = 0.0;
  int blocks = 0;
  for (int y = 0; y + kBlock <= a.height; y += kBlock)
    for (int x = 0; x + kBlock <= a.width; x += kBlock)
      for (int c = 0; c < 3; ++c, ++blocks) {
        double sum = 0.0;
        for (int i = 0; i < kBlock * kBlock; ++i)
          sum += valueAt(a, x + i % kBlock, y + i / kBlock, c) -
                 valueAt(b, x + i % kBlock, y + i / kBlock, c);
        squares += std::pow(sum / (kBlock * kBlock), 2);
      }
  return std::sqrt(squares / blocks);
}

}  // namespace

bool Agreement::holds() const {
  return std::abs(mean / wantedMean - 1.0) <= 0.005 && difference <= 2.0 * noise;
}

std::string Agreement::row(const std::string& name) const {
  return fmt::format("| {} | {:+.2f} % | {:.5f} | {:.5f} | {:.2f} | {} |", name,
                     100.0 * (mean / wantedMean - 1.0), difference, noise, difference / noise,
                     holds() ? "yes" : "no");
}

Agreement agreementOf(const Image& render, const Image& other, const Image& published) {
  for (const Image* image : {&other, &published})
    if (image->width != render.width || image->height != render.height)
      throw std::invalid_argument(fmt::format("{}x{} pixels, expected {}x{}", image->width,
                                              image->height, render.width, render.height));
  return {meanOf(render), meanOf(published), blockDifference(render, published),
          blockDifference(render, other)};
}

}  // namespace laver::test
