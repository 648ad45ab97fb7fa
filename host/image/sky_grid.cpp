#include "image/sky_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace laver {
namespace {

/// 0.7 degrees a cell.
constexpr int kMaxColumns = 512, kMaxRows = 256;

std::vector<float> luminances(const Picture& picture, bool raw) {
  std::array<double, 256> linear{};
  for (std::size_t i = 0; i < 256; ++i) {
    const double encoded = static_cast<double>(i) / 255.0;
    linear[i] = raw ? encoded : linearOfSrgb(encoded);
  }
  const auto luminance = [](double r, double g, double b) {
    return static_cast<float>(0.2126 * r + 0.7152 * g + 0.0722 * b);
  };
  std::vector<float> all;
  if (const auto* bitmap = std::get_if<Bitmap>(&picture)) {
    for (const Rgb8& p : bitmap->pixels)
      all.push_back(luminance(linear[p[0]], linear[p[1]], linear[p[2]]));
  } else {
    const std::vector<float>& p = std::get<Image>(picture).pixels;
    for (std::size_t i = 0; i < p.size(); i += 3)
      all.push_back(luminance(double{p[i]}, double{p[i + 1]}, double{p[i + 2]}));
  }
  return all;
}

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
  const std::vector<float> luminance = luminances(picture, raw);
  SkyGrid grid{{std::min(width, kMaxColumns), std::min(height, kMaxRows)}, {}};
  for (int row = 0; row < grid.size.y; ++row) {
    const auto [top, bottom] = pixelsOf(row, grid.size.y, height);
    for (int column = 0; column < grid.size.x; ++column) {
      const auto [left, right] = pixelsOf(column, grid.size.x, width);
      double sum = 0.0;
      for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
          const int inside = std::clamp(y, 0, height - 1) * width + (x + width) % width;
          sum += std::max(0.0, double{luminance[static_cast<std::size_t>(inside)]});
        }
      const int count = (bottom - top + 1) * (right - left + 1);
      grid.power.push_back(sum / count * cellSolidAngle(grid.size, row));
    }
  }
  return grid;
}

}  // namespace laver
