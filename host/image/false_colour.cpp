#include "image/false_colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace laver {
namespace {

constexpr Rgb8 kEqual = {0, 0, 0}, kNotFinite = {255, 0, 255};
constexpr Rgb8 kPaper = {255, 255, 255}, kInk = {0, 0, 0};

/// viridis (Smith and van der Walt, 2015) at equal steps.
constexpr std::array<Rgb8, 9> kViridis = {{{68, 1, 84},
                                           {71, 45, 123},
                                           {59, 82, 139},
                                           {44, 114, 142},
                                           {33, 144, 140},
                                           {39, 173, 129},
                                           {93, 200, 99},
                                           {170, 220, 50},
                                           {253, 231, 37}}};

/// The colour of the map at t in [0, 1].
Rgb8 viridis(double t) {
  const double at = std::clamp(t, 0.0, 1.0) * (kViridis.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  const double share = at - static_cast<double>(low);
  Rgb8 colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(
        std::lround((1.0 - share) * kViridis[low][c] + share * kViridis[low + 1][c]));
  return colour;
}

std::string label(int exponent) { return exponent == 0 ? "1" : fmt::format("1e{}", exponent); }

/// Layout of the colour scale, in pixels.
struct Layout {
  Layout(int pictureHeight, LogScale scale)
      : dot(std::max(2, pictureHeight / 400)),
        line(textHeight(dot) + 2 * dot),
        height(std::max(pictureHeight, (scale.high - scale.low + 7) * line)),
        barTop(line),
        barHeight(height - 6 * line),
        barWidth(12 * dot),
        width(barWidth + 7 * dot + textWidth("1e-88", dot)) {}

  int dot, line, height;
  int barTop, barHeight, barWidth;
  int width;
};

void drawScale(Bitmap& bitmap, int left, const Layout& layout, LogScale scale) {
  const int x = left + 2 * layout.dot;
  const int textX = x + layout.barWidth + 3 * layout.dot;
  const auto text = [&](int middle, const std::string& words) {
    drawText(bitmap, textX, middle - textHeight(layout.dot) / 2, words, layout.dot, kInk);
  };
  const double decades = scale.high - scale.low;
  for (int i = 0; i < layout.barHeight; ++i) {
    const double share = static_cast<double>(i) / (layout.barHeight - 1);
    bitmap.fill(x, layout.barTop + i, layout.barWidth, 1, viridis(1.0 - share));
  }
  for (int e = scale.low; e <= scale.high; ++e) {
    const double share = (scale.high - e) / decades;
    const int y = layout.barTop + static_cast<int>(std::lround(share * (layout.barHeight - 1)));
    bitmap.fill(x + layout.barWidth, y - layout.dot / 2, 2 * layout.dot, layout.dot, kInk);
    text(y, label(e));
  }
  int y = layout.barTop + layout.barHeight + layout.line;
  for (const auto& [colour, words] : {std::pair(kEqual, "0"), std::pair(kNotFinite, "inf")}) {
    bitmap.fill(x, y, layout.barWidth, layout.line, colour);
    text(y + layout.line / 2, words);
    y += 2 * layout.line;
  }
}

}  // namespace

LogScale scaleFor(std::span<const double> distances) {
  double largest = 0.0;
  for (const double d : distances)
    if (std::isfinite(d)) largest = std::max(largest, d);
  LogScale scale;
  if (largest > 1.0) scale.high = static_cast<int>(std::ceil(std::log10(largest)));
  return scale;
}

Rgb8 falseColour(double distance, LogScale scale) {
  if (distance == 0.0) return kEqual;
  if (!std::isfinite(distance)) return kNotFinite;
  return viridis((std::log10(distance) - scale.low) / (scale.high - scale.low));
}

Bitmap drawDistances(std::span<const double> distances, int width, int height) {
  const LogScale scale = scaleFor(distances);
  const Layout layout(height, scale);
  Bitmap bitmap(width + layout.width, layout.height, kPaper);
  auto next = distances.begin();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) bitmap.at(x, y) = falseColour(*next++, scale);
  drawScale(bitmap, width, layout, scale);
  return bitmap;
}

}  // namespace laver
