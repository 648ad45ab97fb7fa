#include <algorithm>
#include <cmath>

#include "lab/chart/canvas.h"

namespace laver::chart {
namespace {

/// Lines of samples a pixel; across, areas are exact.
constexpr int kLines = 5;

}  // namespace

RasterCanvas::RasterCanvas(int width, int height) : bitmap_(width, height, {255, 255, 255}) {}

void RasterCanvas::cover(int x, int y, double share, Rgb8 colour) {
  share = std::round(share * 32.0) / 32.0;  // few colours make small files
  if (x < 0 || y < 0 || x >= bitmap_.width || y >= bitmap_.height) return;
  Rgb8& pixel = bitmap_.at(x, y);
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::lround(
        std::lerp(static_cast<double>(pixel[c]), static_cast<double>(colour[c]), share)));
}

void RasterCanvas::polygon(std::span<const glm::dvec2> corners, Rgb8 colour, double opacity) {
  double top = bitmap_.height, bottom = 0, left = bitmap_.width, right = 0;
  for (const glm::dvec2 c : corners) {
    top = std::min(top, c.y + origin_.y), bottom = std::max(bottom, c.y + origin_.y);
    left = std::min(left, c.x + origin_.x), right = std::max(right, c.x + origin_.x);
  }
  const int x0 = std::max(0, static_cast<int>(left));
  const int x1 = std::min(bitmap_.width, static_cast<int>(right) + 1);
  if (x0 >= x1) return;
  std::vector<double> shares(static_cast<std::size_t>(x1 - x0)), crossings;
  for (int y = std::max(0, static_cast<int>(top));
       y <= std::min(bitmap_.height - 1, static_cast<int>(bottom)); ++y) {
    std::fill(shares.begin(), shares.end(), 0.0);
    for (int line = 0; line < kLines; ++line) {
      const double at = y + (line + 0.5) / kLines;
      crossings.clear();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i] + origin_, b = corners[(i + 1) % corners.size()] + origin_;
        if ((a.y <= at) != (b.y <= at))
          crossings.push_back(a.x + (at - a.y) / (b.y - a.y) * (b.x - a.x));
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        for (int x = std::max(x0, static_cast<int>(crossings[i])); x < x1 && x < crossings[i + 1];
             ++x)
          shares[static_cast<std::size_t>(x - x0)] +=
              (std::min(crossings[i + 1], x + 1.0) -
               std::max(crossings[i], static_cast<double>(x))) /
              kLines;
    }
    for (int x = x0; x < x1; ++x)
      if (const double share = shares[static_cast<std::size_t>(x - x0)]; share > 0.0)
        cover(x, y, std::min(share, 1.0) * opacity, colour);
  }
}

void RasterCanvas::polyline(std::span<const glm::dvec2> points, double width, Rgb8 colour,
                            double dash) {
  double walked = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = glm::length(points[i + 1] - points[i]);
    if (length == 0.0) continue;
    const glm::dvec2 along = (points[i + 1] - points[i]) / length;
    const glm::dvec2 side = glm::dvec2(-along.y, along.x) * (width / 2.0);
    // Ends that overlap a little close the corners.
    const double cap = dash == 0.0 ? width * 0.3 : 0.0;
    for (double from = 0.0; from < length;) {
      const bool drawn = dash == 0.0 || std::fmod(walked + from, 2.0 * dash) < dash;
      const double step = dash == 0.0 ? length : dash - std::fmod(walked + from, dash);
      const double to = std::min(from + std::max(step, 1e-6), length);
      const glm::dvec2 a = points[i] + along * (from - cap), b = points[i] + along * (to + cap);
      const glm::dvec2 corners[] = {a + side, b + side, b - side, a - side};
      if (drawn) polygon(corners, colour, 1.0);
      from = to;
    }
    walked += length;
  }
}

void RasterCanvas::text(glm::dvec2 at, const std::string& words, double size, Anchor anchor,
                        Rgb8 colour, bool upwards) {
  const double width = static_cast<double>(words.size()) * kAdvance * size;
  double x = anchor == Anchor::Left ? 0.0 : anchor == Anchor::Middle ? -width / 2.0 : -width;
  for (const char letter : words) {
    for (std::vector<glm::dvec2> stroke : strokesOf(letter)) {
      for (glm::dvec2& p : stroke) {
        const glm::dvec2 q(x + p.x * size, -p.y * size);
        p = at + (upwards ? glm::dvec2(q.y, -q.x) : q);
      }
      polyline(stroke, std::max(1.1, size * 0.1), colour, 0.0);
    }
    x += kAdvance * size;
  }
}

}  // namespace laver::chart
