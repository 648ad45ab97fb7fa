#include "image/sky_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/parallel.h"

namespace laver {
namespace {

/// 0.7 degrees a cell.
constexpr int kMaxColumns = 512, kMaxRows = 256;

/// The luminance of a picture's pixels.
class Luminance {
 public:
  Luminance(const Picture& picture, bool raw)
      : bitmap_(std::get_if<Bitmap>(&picture)), image_(std::get_if<Image>(&picture)) {
    for (std::size_t i = 0; i < linear_.size(); ++i) {
      const double encoded = static_cast<double>(i) / 255.0;
      linear_[i] = raw ? encoded : linearOfSrgb(encoded);
    }
  }
  double at(std::size_t i) const {
    if (bitmap_ != nullptr) {
      const Rgb8& p = bitmap_->pixels[i];
      return of(linear_[p[0]], linear_[p[1]], linear_[p[2]]);
    }
    const float* p = &image_->pixels[3 * i];
    return of(double{p[0]}, double{p[1]}, double{p[2]});
  }

 private:
  static double of(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

  const Bitmap* bitmap_;
  const Image* image_;
  std::array<double, 256> linear_{};  // of bytes
};

/// The pixels along an axis, first to last, that are interpolated in a cell.
std::array<int, 2> pixelsOf(int cell, int cells, int pixels) {
  const auto edge = [&](int c) {
    return static_cast<double>(c) * pixels / static_cast<double>(cells) - 0.5;
  };
  return {static_cast<int>(std::floor(edge(cell))),
          static_cast<int>(std::floor(edge(cell + 1))) + 1};
}

}  // namespace

double cellSolidAngle(glm::ivec2 size, int row) {
  constexpr double kPi = std::numbers::pi;
  // 2 pi / columns times the difference of the cosines of both latitudes.
  return 4.0 * kPi / size.x * std::sin(kPi * (row + 0.5) / size.y) * std::sin(0.5 * kPi / size.y);
}

SkyGrid skyGrid(const Picture& picture, bool raw) {
  const int width = widthOf(picture), height = heightOf(picture);
  const Luminance luminance(picture, raw);
  SkyGrid grid{{std::min(width, kMaxColumns), std::min(height, kMaxRows)}, {}};
  const auto columns = static_cast<std::size_t>(grid.size.x);
  grid.power.resize(columns * static_cast<std::size_t>(grid.size.y));
  const auto powerOf = [&](int row, int column) {
    const auto [top, bottom] = pixelsOf(row, grid.size.y, height);
    const auto [left, right] = pixelsOf(column, grid.size.x, width);
    double sum = 0.0;
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const int inside = std::clamp(y, 0, height - 1) * width + (x + width) % width;
        sum += std::max(0.0, luminance.at(static_cast<std::size_t>(inside)));
      }
    const int count = (bottom - top + 1) * (right - left + 1);
    return sum / count * cellSolidAngle(grid.size, row);
  };
  parallelFor(grid.power.size(), columns, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      grid.power[i] = powerOf(static_cast<int>(i / columns), static_cast<int>(i % columns));
  });
  return grid;
}

}  // namespace laver
