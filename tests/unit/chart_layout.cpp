// The drawing of a chart is readable: no label overlaps another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "lab/chart/panels.h"

namespace laver::test {
namespace {

using namespace chart;

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool inside = false;
  for (const char c : line)
    if (c == '"')
      inside = !inside;
    else if (c == ',' && !inside)
      fields.emplace_back();
    else
      fields.back() += c;
  return fields;
}

/// A chart from a CSV file, with one method per triangle test added.
Chart measuredChart(const std::string& file) {
  std::ifstream in(std::string(LAVER_SOURCE_DIR) + "/tests/unit/" + file);
  Chart chart;
  chart.scene = file;
  chart.traversal = "packet32";
  chart.width = chart.height = 256;
  chart.truthSamples = 256;
  chart.truthError = 1e-4;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const auto field = fieldsOf(line);
    if (chart.series.empty() || chart.series.back().name != field[0])
      chart.series.push_back({field[0], field[1], field[2], field[3] == "1", field[4], {}});
    const auto number = [&](std::size_t i) { return std::stod(field[i]); };
    chart.series.back().points.push_back({number(5),
                                          "",
                                          {number(6), number(7), number(8)},
                                          {number(9), number(10), number(11)},
                                          {number(12), number(13)},
                                          {}});
  }
  for (const char* triangles :
       {"Moeller-Trumbore", "Woop, plain products", "Woop with Kahan", "ours"})
    for (int i = 0; i < 6; ++i)
      chart.methods.push_back(
          {triangles, "ours", "32 bits", 90.0 + i, {89.0 + i, 99.0 + i}, 2.5, 1, 49376, 1771});
  return chart;
}

/// Curves whose marks coincide, with long labels.
Panel crowdedPanel() {
  Panel panel{"A title of one line in plain words",
              "rendering alone, milliseconds",
              "error (RMSE; white is 1)",
              {},
              0.02};
  for (int c = 0; c < 6; ++c) {
    Curve curve{"a curve whose name has many letters in it", {0, 0, 0}, Shape::Disc, true, {}};
    for (int i = 0; i < 8; ++i)
      curve.marks.push_back({10.0 + i / 10, 9.0, 12.0, 0.02 + 1e-4 * i, "1048576"});
    panel.curves.push_back(curve);
  }
  return panel;
}

Rect boxOf(const Symbol& symbol) { return {symbol.at - kSymbolRadius, symbol.at + kSymbolRadius}; }

/// Number of overlapping pairs of labels, or of a label and a symbol, and of labels outside the
/// panel.
std::size_t faults(const std::vector<Rect>& labels, const std::vector<Symbol>& symbols) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    count += Rect{{0, 0}, kPanelSize}.contains(labels[i]) ? 0 : 1;
    for (std::size_t j = 0; j < i; ++j) count += labels[i].overlaps(labels[j]) ? 1 : 0;
    for (const Symbol& symbol : symbols) count += labels[i].overlaps(boxOf(symbol)) ? 1 : 0;
  }
  return count;
}

std::vector<Rect> boxesOf(const Layout& layout) {
  std::vector<Rect> boxes;
  for (const Label& label : layout.labels) boxes.push_back(label.box);
  return boxes;
}

std::size_t marksOf(const Panel& panel) {
  std::size_t count = 0;
  for (const Curve& curve : panel.curves) count += curve.marks.size();
  return count;
}

class ChartLayout : public testing::TestWithParam<const char*> {};

TEST_P(ChartLayout, NoLabelLiesOnAnotherOrOnASymbolOrOutsideItsPanel) {
  const Figure figure = figureOf(measuredChart(GetParam()));
  ASSERT_EQ(figure.panels.size(), 4U);
  for (const Panel& panel : figure.panels) {
    SCOPED_TRACE(panel.title);
    const Layout layout = layoutOf(panel, chart::textWidth);
    EXPECT_EQ(faults(boxesOf(layout), layout.symbols), 0U);
    EXPECT_LE(panel.curves.size(), kMaxCurves);
    // Title, axis names, ticks and curve names are all present and complete.
    std::set<std::string> texts;
    for (const Label& label : layout.labels) texts.insert(label.text);
    EXPECT_TRUE(texts.contains(panel.title));
    EXPECT_TRUE(texts.contains(panel.xLabel));
    EXPECT_TRUE(texts.contains(panel.yLabel));
    for (const Curve& curve : panel.curves) EXPECT_TRUE(texts.contains(curve.name)) << curve.name;
    EXPECT_EQ(layout.symbols.size(), marksOf(panel) + panel.curves.size());
  }
}

TEST_P(ChartLayout, LabelsAtAFixedSideWouldOverlap) {
  std::size_t found = 0;
  for (const Panel& panel : figureOf(measuredChart(GetParam())).panels) {
    const Layout layout = layoutOf(panel, chart::textWidth);
    std::vector<Rect> boxes;
    for (std::size_t i = panel.curves.size(); i < layout.symbols.size(); ++i) {
      const glm::dvec2 at = layout.symbols[i].at + glm::dvec2(6, -5);
      boxes.push_back({at - glm::dvec2(0, 8), at + glm::dvec2(12, 2)});
    }
    found += faults(boxes, layout.symbols);
  }
  EXPECT_GT(found, 10U);
}

/// Measured by `laver chart` at 256 x 256 pixels, with Mitsuba as peer.
INSTANTIATE_TEST_SUITE_P(Measured, ChartLayout,
                         testing::Values("chart-bunny-whitted.csv", "chart-cornell.csv"));

TEST(ChartPanel, OfCoincidentMarksHasNoOverlaps) {
  const Panel panel = crowdedPanel();
  const Layout layout = layoutOf(panel, chart::textWidth);
  EXPECT_EQ(faults(boxesOf(layout), layout.symbols), 0U);
  EXPECT_EQ(layout.symbols.size(), 6U * 8U + 6U);
}

TEST(ChartPanel, LabelsMarksThatHaveRoom) {
  Panel panel{"Title", "x", "y", {{"curve", {0, 0, 0}, Shape::Disc, true, {}}}, 0};
  for (int i = 0; i < 4; ++i) {
    const double x = std::pow(4.0, i);
    panel.curves[0].marks.push_back({x, x, x, 1.0 / x, std::to_string(1 << (2 * i))});
  }
  std::set<std::string> texts;
  for (const Label& label : layoutOf(panel, chart::textWidth).labels)
    if (label.colour == panel.curves[0].colour) texts.insert(label.text);
  EXPECT_EQ(texts, (std::set<std::string>{"1", "4", "16", "64"}));
}

TEST(ChartPanel, LeavesOutValuesThatAreNotPositive) {
  Panel panel{"Title", "x", "y", {{"curve", {0, 0, 0}, Shape::Disc, true, {}}}, 0};
  for (const double y : {1.0, 0.0, -1.0, std::nan(""), 0.1})
    panel.curves[0].marks.push_back({1.0, 1.0, 1.0, y, "label"});
  EXPECT_EQ(layoutOf(panel, chart::textWidth).symbols.size(), 1U + 2U);
}

TEST(ChartPanel, TruncatesNamesThatAreWiderThanThePanel) {
  Panel panel{
      std::string(200, 'W'), "x", "y", {{std::string(200, 'M'), {}, Shape::Disc, true, {}}}, 0};
  const Layout layout = layoutOf(panel, chart::textWidth);
  EXPECT_EQ(faults(boxesOf(layout), layout.symbols), 0U);
}

TEST(ChartFigure, IsAnSvgAndAPngOfTheWidthOfAReadme) {
  const Figure figure = figureOf(measuredChart("chart-cornell.csv"));
  const std::string svg = svgOf(figure);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("width=\"860"), std::string::npos) << svg.substr(0, 300);
  EXPECT_NE(svg.rfind("</svg>"), std::string::npos);
  const std::string png = pngOf(figure, 2.0);
  ASSERT_GT(png.size(), 1000U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  // Big-endian width in the header.
  EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]), 1720);
}

TEST(ChartFigure, NamesPeersThatAreMissingAndLeavesOutEmptyPanels) {
  Chart chart;
  chart.missing = {"Mitsuba 3: not installed"};
  const Figure figure = figureOf(chart);
  EXPECT_TRUE(figure.panels.empty());
  EXPECT_TRUE(std::any_of(figure.notes.begin(), figure.notes.end(), [](const std::string& note) {
    return note.find("Mitsuba 3: not installed") != std::string::npos;
  }));
  EXPECT_FALSE(svgOf(figure).empty());
}

TEST(ChartFigure, APeerLooksTheSameInEveryPanel) {
  const Figure figure = figureOf(measuredChart("chart-cornell.csv"));
  std::map<std::string, std::set<Colour>> colours;
  for (const Panel& panel : figure.panels) {
    std::set<Colour> inPanel;
    for (const Curve& curve : panel.curves) {
      EXPECT_TRUE(inPanel.insert(curve.colour).second) << panel.title << ": " << curve.name;
      colours[curve.name].insert(curve.colour);
    }
  }
  for (const auto& [name, of] : colours) EXPECT_EQ(of.size(), 1U) << name;
  EXPECT_GE(colours.size(), 10U);
}

}  // namespace
}  // namespace laver::test
