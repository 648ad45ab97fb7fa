#include "lab/chart/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "lab/chart/numbers.h"

namespace laver::chart {
namespace {

using glm::dvec2;

constexpr double kTitle = 13, kText = 11, kSmall = 10;
constexpr double kMargin = 8, kLine = 16;
constexpr double kAscent = 0.8, kDescent = 0.25;  ///< of a text, in units of its size
constexpr Colour kGrid{228, 228, 228};

bool isShown(const Mark& mark) {
  return std::isfinite(mark.x) && mark.x > 0.0 && std::isfinite(mark.y) && mark.y > 0.0;
}

std::string tickText(double value) {
  if (value >= 1e-4 && value < 1e5) return fmt::format("{:.6g}", value);
  return fmt::format("{:.0e}", value);
}

/// Whether a segment intersects a box (Liang and Barsky, 1984).
bool crosses(dvec2 a, dvec2 b, const Rect& box) {
  double begin = 0.0, end = 1.0;
  const dvec2 d = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (a[axis] < box.lo[axis] || a[axis] > box.hi[axis]) return false;
      continue;
    }
    const double t0 = (box.lo[axis] - a[axis]) / d[axis], t1 = (box.hi[axis] - a[axis]) / d[axis];
    begin = std::max(begin, std::min(t0, t1));
    end = std::min(end, std::max(t0, t1));
  }
  return begin <= end;
}

class Builder {
 public:
  Builder(const Panel& panel, const TextWidth& widthOf) : panel_(panel), widthOf_(widthOf) {}

  Layout build() {
    addText({kMargin, kLine}, panel_.title, kTitle, true, kInk);
    const double legendEnd = addLegend(2 * kLine + 2);
    frame_ = {{kLeft, legendEnd}, {kPanelSize.x - 14, kPanelSize.y - 44}};
    findAxes();
    addShade();
    addAxes();
    for (const Curve& curve : panel_.curves) addCurve(curve);
    addShadeLabel();
    for (const Curve& curve : panel_.curves)
      for (const Mark& mark : curve.marks)
        if (isShown(mark) && !mark.label.empty()) addMarkLabel(curve, mark);
    return std::move(layout_);
  }

 private:
  static constexpr double kLeft = 62;

  Label label(dvec2 at, const std::string& text, double size, bool bold, Colour colour) const {
    const double width = widthOf_(text, size, bold);
    return {text,
            at,
            size,
            bold,
            false,
            colour,
            {{at.x, at.y - kAscent * size}, {at.x + width, at.y + kDescent * size}}};
  }

  bool isFree(const Rect& box) const {
    return Rect{{0, 0}, kPanelSize}.contains(box) &&
           std::none_of(taken_.begin(), taken_.end(),
                        [&](const Rect& other) { return box.overlaps(other); });
  }

  void add(const Label& label) {
    taken_.push_back(label.box);
    layout_.labels.push_back(label);
  }

  /// A text that is always drawn, truncated if it is too wide.
  void addText(dvec2 at, std::string text, double size, bool bold, Colour colour) {
    const double room = kPanelSize.x - kMargin - at.x;
    if (widthOf_(text, size, bold) > room) {
      while (!text.empty() && widthOf_(text + "...", size, bold) > room) text.pop_back();
      text += "...";
    }
    add(label(at, text, size, bold, colour));
  }

  /// A text that is drawn only if there is room.
  void addIfFree(const Label& label) {
    if (isFree(label.box)) add(label);
  }

  /// The names of the curves, in rows; returns where they end.
  double addLegend(double y) {
    double x = kMargin;
    for (const Curve& curve : panel_.curves) {
      const double width = 14 + widthOf_(curve.name, kText, false);
      if (x > kMargin && x + width > kPanelSize.x - kMargin) {
        x = kMargin;
        y += kLine;
      }
      layout_.symbols.push_back({{x + kSymbolRadius, y - 0.35 * kText}, curve.shape, curve.colour});
      addText({x + 14, y}, curve.name, kText, false, kInk);
      x += width + 14;
    }
    return y + 10;
  }

  void findAxes() {
    std::vector<double> xs, ys;
    for (const Curve& curve : panel_.curves)
      for (const Mark& mark : curve.marks) {
        if (!isShown(mark)) continue;
        xs.insert(xs.end(), {mark.x, mark.low, mark.high});
        ys.push_back(mark.y);
      }
    x_ = axisAround(xs);
    y_ = axisAround(ys);
  }

  double xAt(double x) const { return std::lerp(frame_.lo.x, frame_.hi.x, x_.at(x)); }
  double yAt(double y) const { return std::lerp(frame_.hi.y, frame_.lo.y, y_.at(y)); }
  dvec2 at(const Mark& mark) const { return {xAt(mark.x), yAt(mark.y)}; }

  void addShade() {
    if (!(panel_.uncertainBelow > y_.low)) return;
    const double y = std::max(frame_.lo.y, yAt(panel_.uncertainBelow));
    layout_.shades.push_back({{frame_.lo.x, y}, frame_.hi});
  }

  void addShadeLabel() {
    if (!layout_.shades.empty() && layout_.shades[0].hi.y - layout_.shades[0].lo.y > kLine)
      addIfFree(label({frame_.lo.x + 5, frame_.hi.y - 5}, "below the reference's own error", kSmall,
                      false, kGrey));
  }

  void addAxes() {
    for (const double tick : x_.ticks()) {
      const double x = xAt(tick);
      layout_.strokes.push_back({{{x, frame_.lo.y}, {x, frame_.hi.y}}, 1, kGrid});
      const double width = widthOf_(tickText(tick), kText, false);
      addIfFree(label({x - width / 2, frame_.hi.y + 15}, tickText(tick), kText, false, kInk));
    }
    for (const double tick : y_.ticks()) {
      const double y = yAt(tick);
      layout_.strokes.push_back({{{frame_.lo.x, y}, {frame_.hi.x, y}}, 1, kGrid});
      const double width = widthOf_(tickText(tick), kText, false);
      addIfFree(label({frame_.lo.x - 5 - width, y + 4}, tickText(tick), kText, false, kInk));
    }
    layout_.strokes.push_back(
        {{{frame_.lo.x, frame_.lo.y}, {frame_.lo.x, frame_.hi.y}, frame_.hi}, 1.2, kInk});
    const double width = widthOf_(panel_.xLabel, kText, false);
    add(label({(frame_.lo.x + frame_.hi.x - width) / 2, frame_.hi.y + 33}, panel_.xLabel, kText,
              false, kInk));
    const double length = widthOf_(panel_.yLabel, kText, false);
    const dvec2 foot(16, (frame_.lo.y + frame_.hi.y + length) / 2);
    add({panel_.yLabel,
         foot,
         kText,
         false,
         true,
         kInk,
         {{foot.x - kAscent * kText, foot.y - length}, {foot.x + kDescent * kText, foot.y}}});
  }

  void addCurve(const Curve& curve) {
    std::vector<dvec2> points;
    for (const Mark& mark : curve.marks) {
      if (!isShown(mark)) continue;
      const dvec2 p = at(mark);
      points.push_back(p);
      layout_.symbols.push_back({p, curve.shape, curve.colour});
      layout_.strokes.push_back({{{xAt(mark.low), p.y}, {xAt(mark.high), p.y}}, 2.5, curve.colour});
      taken_.push_back({p - kSymbolRadius, p + kSymbolRadius});
    }
    if (curve.joined && points.size() > 1)
      layout_.strokes.push_back({std::move(points), 1.5, curve.colour});
  }

  /// Next to the mark, at the free position that crosses the fewest lines.
  void addMarkLabel(const Curve& curve, const Mark& mark) {
    const dvec2 p = at(mark);
    const double width = widthOf_(mark.label, kSmall, false), height = kAscent * kSmall;
    const double gap = kSymbolRadius + 2;
    const dvec2 places[] = {{gap, -gap + 1},
                            {gap, height / 2},
                            {-width / 2, -gap},
                            {-width / 2, gap + height},
                            {gap, gap + height - 1},
                            {-gap - width, height / 2},
                            {-gap - width, gap + height - 1},
                            {-gap - width, -gap + 1}};
    std::optional<Label> best;
    std::size_t fewest = 0;
    for (const dvec2 place : places) {
      const Label candidate = label(p + place, mark.label, kSmall, false, curve.colour);
      if (!frame_.contains(candidate.box) || !isFree(candidate.box)) continue;
      const std::size_t crossed = linesIn(candidate.box);
      if (best && crossed >= fewest) continue;
      best = candidate;
      fewest = crossed;
    }
    if (best) add(*best);
  }

  std::size_t linesIn(const Rect& box) const {
    std::size_t count = 0;
    for (const Stroke& stroke : layout_.strokes)
      for (std::size_t i = 0; stroke.colour != kGrid && i + 1 < stroke.points.size(); ++i)
        count += crosses(stroke.points[i], stroke.points[i + 1], box) ? 1 : 0;
    return count;
  }

  const Panel& panel_;
  const TextWidth& widthOf_;
  Rect frame_{};  ///< between the axes
  LogAxis x_, y_;
  std::vector<Rect> taken_;
  Layout layout_;
};

}  // namespace

Layout layoutOf(const Panel& panel, const TextWidth& widthOf) {
  return Builder(panel, widthOf).build();
}

}  // namespace laver::chart
