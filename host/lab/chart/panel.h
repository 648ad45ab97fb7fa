#pragma once
#include <string>
#include <vector>

#include "lab/chart/canvas.h"
#include "lab/chart/chart.h"

namespace laver::chart {

enum class Shape { Disc, Square, Diamond, Triangle };

/// A point as it is drawn; x has quartiles.
struct Mark {
  double x, low, high, y;
  std::string link, title;
  std::string label;  ///< drawn beside it; empty: none
};

/// Marks that a line joins.
struct Curve {
  std::string label;
  Rgb8 colour;
  Shape shape;
  std::vector<Mark> marks;
  bool joined = true;
};

/// A horizontal line, or with `area` a band from there to the bottom.
struct Level {
  double y;
  std::string label;
  bool area;
};

/// Two logarithmic axes, the better the smaller, and what lies between. Marks with y = 0 stand in a
/// row of their own at the bottom.
struct Panel {
  std::string title, xLabel, yLabel;
  std::vector<Curve> curves;
  std::vector<double> slopes;  ///< dashed lines of theory through the last mark of the first curve
  std::vector<Level> levels;
  std::vector<std::string> notes;  ///< lines below the legend
};

inline constexpr int kPanelWidth = 760, kPanelHeight = 460;
void draw(const Panel& panel, Canvas& canvas);

/// What error is measured by.
struct Metric {
  const char* name;   ///< as --metric has it
  const char* label;  ///< of the axis
};
inline constexpr Metric kMetrics[] = {{"rmse", "error: RMSE"},
                                      {"relmse", "error: relative MSE"},
                                      {"unexplained", "unexplained mismatches, share of pixels"}};
/// NaN where it was not measured.
double valueOf(const Point& point, const Chart& chart, const std::string& metric);

/// Panel A, or B with `process`: the points of one filter.
Panel timePanel(const Chart& chart, std::size_t filter, const std::string& metric, bool process);

/// Panel C: "t", "normal" or "unexplained" over time.
Panel methodPanel(const Chart& chart, const std::string& quantity);

/// Where a point or method stands in the page.
std::string anchorOf(std::size_t point);
std::string methodAnchor(std::size_t method);

}  // namespace laver::chart
