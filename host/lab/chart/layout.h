#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace laver::chart {

using Colour = std::array<std::uint8_t, 3>;
enum class Shape { Disc, Square, Diamond, Triangle };

/// A point of a curve; x has quartiles.
struct Mark {
  double x, low, high, y;
  std::string label;  ///< placed beside it where there is room; empty: none
};

struct Curve {
  std::string name;
  Colour colour;
  Shape shape;
  bool joined;  ///< a line connects the marks
  std::vector<Mark> marks;
};

/// Two logarithmic axes, smaller is better on both. Marks whose x or y is not above 0 are left out.
struct Panel {
  std::string title, xLabel, yLabel;
  std::vector<Curve> curves;
  double uncertainBelow = 0;  ///< y below which the truth is not exact enough; 0: none
};

/// Lengths are in pixels, y down, from the panel's top left.
struct Rect {
  glm::dvec2 lo, hi;
  bool overlaps(const Rect& other) const {
    return lo.x < other.hi.x && other.lo.x < hi.x && lo.y < other.hi.y && other.lo.y < hi.y;
  }
  bool contains(const Rect& other) const {
    return lo.x <= other.lo.x && lo.y <= other.lo.y && other.hi.x <= hi.x && other.hi.y <= hi.y;
  }
};

struct Label {
  std::string text;
  glm::dvec2 at;  ///< where the baseline begins
  double size;
  bool bold, upwards;
  Colour colour;
  Rect box;
};

struct Stroke {
  std::vector<glm::dvec2> points;
  double width;
  Colour colour;
};

struct Symbol {
  glm::dvec2 at;
  Shape shape;
  Colour colour;
};

/// What is drawn, in this order.
struct Layout {
  std::vector<Rect> shades;  ///< areas of the colour kShade
  std::vector<Stroke> strokes;
  std::vector<Symbol> symbols;
  std::vector<Label> labels;
};

/// The width of a text in pixels.
using TextWidth = std::function<double(const std::string& text, double size, bool bold)>;

inline constexpr glm::dvec2 kPanelSize{430, 340};
inline constexpr double kSymbolRadius = 4;
inline constexpr Colour kInk{40, 40, 40}, kGrey{110, 110, 110}, kShade{246, 240, 226};

/// No label overlaps another or a symbol; a mark's label that finds no room is left out.
Layout layoutOf(const Panel& panel, const TextWidth& widthOf);

}  // namespace laver::chart
