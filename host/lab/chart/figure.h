#pragma once
#include <string>
#include <vector>

#include "lab/chart/layout.h"

namespace laver::chart {

/// A drawing: lines of text, panels in two columns, lines of text.
struct Figure {
  std::string title;
  std::vector<std::string> introduction;
  std::vector<Panel> panels;
  std::vector<std::string> notes;
};

/// Pixels: what a README shows.
inline constexpr double kFigureWidth = 2 * kPanelSize.x;

/// In the font that the figure is drawn in.
double textWidth(const std::string& text, double size, bool bold);

/// The figure as an SVG file, letters as outlines, and as a PNG file of `scale` times its size.
/// Throws Error(Output).
std::string svgOf(const Figure& figure);
std::string pngOf(const Figure& figure, double scale);

}  // namespace laver::chart
