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

/// A point of a curve; low and high are the quartiles of x.
struct Mark {
  double x, low, high, y;
  std::string label;  ///< drawn next to the mark if there is room; empty: none
};

struct Curve {
  std::string name;
  Colour colour;
  Shape shape;
  bool joined;  ///< a line connects the marks
  std::vector<Mark> marks;
};

/// Two logarithmic axes; smaller is better on both. Marks with x <= 0 or y <= 0 are not drawn.
struct Panel {
  std::string title, xLabel, yLabel;
  std::vector<Curve> curves;
  double uncertainBelow = 0;  ///< y below which the reference is not exact enough; 0: none
};

/// A rectangle in pixels, y down, relative to the panel's top left.
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
  glm::dvec2 at;  ///< start of the baseline
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

/// The elements of a panel, in drawing order.
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

/// Arranges a panel. No label overlaps another label or a symbol; labels of marks that do not fit
/// are left out.
Layout layoutOf(const Panel& panel, const TextWidth& widthOf);

}  // namespace laver::chart
