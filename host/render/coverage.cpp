#include "render/coverage.h"

#include <algorithm>
#include <limits>

#include "shared/layout.h"

namespace laver {
namespace {

constexpr int kColumns = shared::SLOT_COLUMNS;
constexpr int kUnits = 256;  // limit on the groups of rows at which a rectangle may begin

int multipleBelow(int x) { return x / kColumns * kColumns; }

}  // namespace

void Coverage::Span::widen(const Span& s) {
  if (s.empty()) return;
  *this = empty() ? s : Span{std::min(x0, s.x0), std::max(x1, s.x1)};
}

Coverage::Coverage(int width, int height)
    : width_(width), rows_(static_cast<std::size_t>(height), Span{0, 0}) {}

Coverage Coverage::whole(int width, int height) {
  Coverage all(width, height);
  all.add({0, 0, width, height});
  return all;
}

void Coverage::add(const Crop& pixels) {
  const Span span{std::max(pixels.x0, 0), std::min(pixels.x1, width_)};
  const int end = std::min(pixels.y1, height());
  for (int y = std::max(pixels.y0, 0); y < end; ++y) rows_[static_cast<std::size_t>(y)].widen(span);
}

bool Coverage::contains(const Crop& pixels) const {
  const Span span{std::max(pixels.x0, 0), std::min(pixels.x1, width_)};
  if (span.empty()) return true;
  const int end = std::min(pixels.y1, height());
  for (int y = std::max(pixels.y0, 0); y < end; ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    if (row.empty() || row.x0 > span.x0 || row.x1 < span.x1) return false;
  }
  return true;
}

bool Coverage::intersects(const Crop& pixels) const {
  const int end = std::min(pixels.y1, height());
  for (int y = std::max(pixels.y0, 0); y < end; ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    if (std::max(row.x0, pixels.x0) < std::min(row.x1, pixels.x1)) return true;
  }
  return false;
}

Coverage Coverage::grown(int reach) const {
  Coverage all(width_, height());
  for (int y = 0; y < height(); ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    if (!row.empty()) all.add({row.x0 - reach, y - reach, row.x1 + reach, y + reach + 1});
  }
  return all;
}

Coverage::Span Coverage::ofRows(int y0, int y1) const {
  Span hull{0, 0};
  for (int y = y0; y < y1; ++y) hull.widen(rows_[static_cast<std::size_t>(y)]);
  return hull;
}

double Coverage::share(const Crop& area) const {
  double pixels = 0;
  for (int y = area.y0; y < area.y1; ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    pixels += std::max(0, std::min(row.x1, area.x1) - std::max(row.x0, area.x0));
  }
  return pixels / (static_cast<double>(area.x1 - area.x0) * (area.y1 - area.y0));
}

std::vector<Crop> Coverage::parts(const Crop& area, const Costs& costs) const {
  std::vector<Crop> units;
  const int unit = (area.y1 - area.y0 + kUnits - 1) / kUnits;
  for (int y = area.y0; y < area.y1; y += unit) {
    const int end = std::min(y + unit, area.y1);
    const Span hull = ofRows(y, end);
    const int x0 = area.x0 + multipleBelow(std::max(hull.x0 - area.x0, 0));
    units.push_back({x0, y, std::min(hull.x1, area.x1), end});
  }
  // cheapest[i] is the minimum cost of the first i units; from[i] is where the last of its
  // rectangles begins.
  std::vector<double> cheapest(units.size() + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(units.size() + 1);
  cheapest[0] = 0;
  for (std::size_t i = 0; i < units.size(); ++i) {
    Span hull{0, 0};
    for (std::size_t j = i + 1; j-- > 0;) {
      hull.widen({units[j].x0, units[j].x1});
      const double width = hull.x1 - hull.x0;
      const double cost =
          hull.empty() ? 0.0 : width * (units[i].y1 - units[j].y0 + costs.column) + costs.each;
      if (cheapest[j] + cost < cheapest[i + 1]) {
        cheapest[i + 1] = cheapest[j] + cost;
        from[i + 1] = j;
      }
    }
  }
  std::vector<Crop> rectangles;
  for (std::size_t end = units.size(); end != 0; end = from[end]) {
    Span hull{0, 0};
    for (std::size_t j = from[end]; j < end; ++j) hull.widen({units[j].x0, units[j].x1});
    if (hull.empty()) continue;
    int y0 = units[from[end]].y0, y1 = units[end - 1].y1;
    while (ofRows(y0, y0 + 1).empty()) ++y0;
    while (ofRows(y1 - 1, y1).empty()) --y1;
    rectangles.push_back({hull.x0, y0, hull.x1, y1});
  }
  std::reverse(rectangles.begin(), rectangles.end());
  return rectangles;
}

}  // namespace laver
