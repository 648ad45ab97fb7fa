#pragma once
#include <string>
#include <vector>

#include "lab/chart/layout.h"

namespace laver::chart {

/// A drawing: a title, lines of text, panels in two columns, lines of text.
struct Figure {
  std::string title;
  std::vector<std::string> introduction;
  std::vector<Panel> panels;
  std::vector<std::string> notes;
};

/// The width at which a README shows a picture, in pixels.
inline constexpr double kFigureWidth = 2 * kPanelSize.x;

/// Width of a text in the figure's font, in pixels.
double textWidth(const std::string& text, double size, bool bold);

/// The figure as an SVG file with letters as outlines, and as a PNG file of `scale` times its size.
/// Throws Error(Output).
std::string svgOf(const Figure& figure);
std::string pngOf(const Figure& figure, double scale);

}  // namespace laver::chart
