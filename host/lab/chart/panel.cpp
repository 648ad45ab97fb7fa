#include "lab/chart/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/chart/numbers.h"

namespace laver::chart {
namespace {

using glm::dvec2;
constexpr Rgb8 kInk{40, 40, 40}, kGrid{228, 228, 228}, kFaint{130, 130, 130}, kBand{244, 239, 226},
    kFront{200, 200, 200};
constexpr double kLeft = 78, kRight = kPanelWidth - 214, kTop = 34, kBottom = kPanelHeight - 50;
constexpr double kText = 12.5, kZeroRow = 24;

std::string tickText(double value) {
  if (value >= 1e-3 && value < 1e4) return fmt::format("{:g}", value);
  const double exponent = std::floor(std::log10(value) + 1e-9);
  const double mantissa = value / std::pow(10.0, exponent);
  return mantissa < 1.5 ? fmt::format("1e{:g}", exponent)
                        : fmt::format("{:.0f}e{:g}", mantissa, exponent);
}

class Drawing {
 public:
  Drawing(const Panel& panel, Canvas& canvas) : panel_(panel), canvas_(canvas) {
    std::vector<double> xs, ys;
    for (const Curve& curve : panel.curves)
      for (const Mark& mark : curve.marks) {
        if (std::isnan(mark.y)) continue;
        for (const double x : {mark.x, mark.low, mark.high}) xs.push_back(x);
        ys.push_back(mark.y);
        zeros_ = zeros_ || mark.y == 0.0;
      }
    // A level far below the marks would press them together.
    for (const Level& level : panel.levels)
      if (!ys.empty() && level.y > *std::min_element(ys.begin(), ys.end()) / 30.0)
        ys.push_back(level.y);
    x_ = axisAround(xs);
    y_ = axisAround(ys);
    bottom_ = zeros_ ? kBottom - kZeroRow : kBottom;
  }

  void run() {
    levels();
    axes();
    slopes();
    front();
    for (const Curve& curve : panel_.curves) this->curve(curve);
    legend();
  }

 private:
  double yAt(double y) const {
    return y == 0.0 ? kBottom - kZeroRow / 2 : bottom_ + (kTop - bottom_) * y_.at(y);
  }
  dvec2 at(double x, double y) const { return {kLeft + (kRight - kLeft) * x_.at(x), yAt(y)}; }
  void line(dvec2 a, dvec2 b, double width, Rgb8 colour, double dash = 0.0) {
    const dvec2 points[] = {a, b};
    canvas_.polyline(points, width, colour, dash);
  }
  void words(dvec2 where, const std::string& text, Anchor anchor, Rgb8 colour = kInk,
             double size = kText) {
    canvas_.text(where, text, size, anchor, colour, false);
  }

  void levels() {
    for (const Level& level : panel_.levels) {
      if (!level.area || !(level.y > y_.low)) continue;
      const double y = std::max(kTop, yAt(level.y));
      const dvec2 box[] = {{kLeft, y}, {kRight, y}, {kRight, bottom_}, {kLeft, bottom_}};
      canvas_.polygon(box, kBand, 1.0);
    }
  }

  void axes() {
    words({kLeft, 20}, panel_.title, Anchor::Left, kInk, 15);
    for (const double tick : x_.ticks()) {
      const double x = at(tick, y_.low).x;
      line({x, kTop}, {x, kBottom}, 1, kGrid);
      words({x, kBottom + 16}, tickText(tick), Anchor::Middle);
    }
    for (const double tick : y_.ticks()) {
      line({kLeft, yAt(tick)}, {kRight, yAt(tick)}, 1, kGrid);
      words({kLeft - 6, yAt(tick) + 4}, tickText(tick), Anchor::Right);
    }
    if (zeros_) {
      line({kLeft, bottom_}, {kRight, bottom_}, 1, kFaint);
      words({kLeft - 6, kBottom - kZeroRow / 2 + 4}, "0", Anchor::Right);
    }
    for (const dvec2 end : {dvec2(kLeft, kTop), dvec2(kRight, kBottom)})
      line({kLeft, kBottom}, end, 1.2, kInk);
    words({(kLeft + kRight) / 2, kBottom + 38}, panel_.xLabel, Anchor::Middle);
    canvas_.text({20, (kTop + kBottom) / 2}, panel_.yLabel, kText, Anchor::Middle, kInk, true);
    double stacked = bottom_ - 6;
    for (const Level& level : panel_.levels) {
      const bool inside = level.y > y_.low && level.y < y_.high;
      if (inside && !level.area)
        line({kLeft, yAt(level.y)}, {kRight, yAt(level.y)}, 1.2, kFaint, 3);
      const std::string text =
          inside ? level.label : fmt::format("{}: {:.2g}, further down", level.label, level.y);
      double y = inside ? yAt(level.y) + (level.area ? 14 : -4) : stacked;
      if (y > stacked - 14) {
        y = stacked;
        stacked -= 15;
      }
      words({kLeft + 6, y}, text, Anchor::Left, kFaint, 11.5);
    }
  }

  /// Through the last mark of the first curve, cut to the frame.
  void slopes() {
    if (panel_.curves.empty() || panel_.curves[0].marks.empty()) return;
    const Mark& from = panel_.curves[0].marks.back();
    if (!(from.y > 0.0)) return;
    for (const double slope : panel_.slopes) {
      const double highest = std::min(y_.high, from.y * std::pow(x_.low / from.x, slope));
      const double first = from.x * std::pow(highest / from.y, 1.0 / slope);
      const double lowest = std::max(y_.low, from.y * std::pow(x_.high / from.x, slope));
      const double last = from.x * std::pow(lowest / from.y, 1.0 / slope);
      line(at(first, highest), at(last, lowest), 1, kFaint, 6);
      words(at(first, highest) + dvec2(4, 14), slope == -0.5 ? "slope -1/2" : "slope -3/4",
            Anchor::Left, kFaint, 11.5);
    }
  }

  /// What no other beats on both axes, as a staircase.
  void front() {
    std::vector<Place> places;
    for (const Curve& curve : panel_.curves)
      for (const Mark& mark : curve.marks) places.push_back({mark.x, mark.y});
    std::vector<dvec2> steps;
    for (const std::size_t i : paretoFront(places)) {
      const dvec2 p = at(places[i].x, places[i].y);
      if (!steps.empty()) steps.emplace_back(p.x, steps.back().y);
      steps.push_back(p);
    }
    if (steps.size() > 1) canvas_.polyline(steps, 5, kFront, 0.0);
    hasFront_ = steps.size() > 1;
  }

  void shape(dvec2 p, Shape shape, double r, Rgb8 colour) {
    std::vector<dvec2> corners;
    const int n = shape == Shape::Disc ? 16 : shape == Shape::Triangle ? 3 : 4;
    const double turn = shape == Shape::Square ? 0.25 * std::numbers::pi : 0.5 * std::numbers::pi;
    for (int i = 0; i < n; ++i) {
      const double angle = turn + 2.0 * std::numbers::pi * i / n;
      corners.push_back(p + r * dvec2(std::cos(angle), -std::sin(angle)));
    }
    canvas_.polygon(corners, colour, 1.0);
  }

  void curve(const Curve& curve) {
    std::vector<dvec2> points;
    for (const Mark& mark : curve.marks)
      if (!std::isnan(mark.y)) points.push_back(at(mark.x, mark.y));
    if (curve.joined && points.size() > 1) canvas_.polyline(points, 1.6, curve.colour, 0.0);
    for (const Mark& mark : curve.marks) {
      if (std::isnan(mark.y)) continue;
      canvas_.beginLink(mark.link, mark.title);
      const dvec2 p = at(mark.x, mark.y);
      line({at(mark.low, mark.y).x, p.y}, {at(mark.high, mark.y).x, p.y}, 3, curve.colour);
      shape(p, curve.shape, 5.5, curve.colour);
      if (!mark.label.empty()) words(p + dvec2(7, -6), mark.label, Anchor::Left, curve.colour, 11);
      canvas_.endLink();
    }
  }

  void legend() {
    double y = kTop + 10;
    const double x = kRight + 18;
    for (const Curve& curve : panel_.curves) {
      shape({x, y - 4}, curve.shape, 5.5, curve.colour);
      words({x + 12, y}, curve.label, Anchor::Left);
      y += 19;
    }
    if (hasFront_) {
      line({x - 7, y - 4}, {x + 7, y - 4}, 5, kFront);
      words({x + 12, y}, "best for its time", Anchor::Left);
      y += 19;
    }
    for (const std::string& note : panel_.notes)
      words({x - 7, y += 16}, note, Anchor::Left, kFaint, 11.5);
  }

  const Panel& panel_;
  Canvas& canvas_;
  LogAxis x_, y_;
  double bottom_;
  bool zeros_ = false, hasFront_ = false;
};

}  // namespace

void draw(const Panel& panel, Canvas& canvas) { Drawing(panel, canvas).run(); }

}  // namespace laver::chart
