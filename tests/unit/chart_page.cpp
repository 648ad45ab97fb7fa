// A chart's files, from figures made up.
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <sstream>

#include "lab/chart/page.h"
#include "lab/chart/panel.h"

namespace laver::chart {
namespace {

Chart someChart() {
  Chart chart;
  chart.scene = "folder/<box> & more.xml";
  chart.machine = "a machine, 2 threads";
  chart.device = "llvmpipe";
  chart.date = "2026-01-02";
  chart.width = chart.height = 10;
  chart.truthSamples = 64;
  chart.filters = {filterOf(filters::gaussian), filterOf(filters::box)};
  chart.truths = {{{}, 0.001, 1e-6}, {{}, 0.002, 2e-6}};
  chart.floatFloor = 1e-6;
  for (const char* filter : {"gaussian", "box"})
    for (const int samples : {1, 4, 16}) {
      Point p;
      p.filter = rowCalled(filterRows(), filter);
      p.program = "laver";
      p.sampler = "independent";
      p.series = std::string("independent, ") + filter;
      p.samples = samples;
      p.passSeconds = {samples * 0.01, samples * 0.02, samples * 0.012};
      p.processSeconds = {0.3, 0.31, 0.5};
      p.errors = {0.1 / std::sqrt(samples), 0.01 / samples};
      if (samples < 16) p.mismatches = Mismatches{5, samples == 1 ? 0U : 2U, 1e-6};
      p.thumbnail = p.errorMap = "data:image/png;base64,AAAA";
      chart.points.push_back(p);
    }
  Point peer;
  peer.program = peer.series = "other, \"quoted\" <peer>";
  peer.filter = &filters::gaussian;
  peer.passSeconds = peer.processSeconds = {0.5};
  peer.errors = {0.05, 0.002};
  peer.thumbnail = peer.errorMap = "data:image/png;base64,AAAA";
  chart.points.push_back(peer);
  chart.methods = {{"ours", "ours", "32 bits", 50, {49, 52}, 0.5, 1.0, 100, 0},
                   {"Moeller-Trumbore", "plain slabs", "32 bits", 40, {39, 41}, 5, 9, 100, 12}};
  return chart;
}

TEST(ChartJson, HoldsEveryPointAndWhatItWasMadeOf) {
  const nlohmann::json json = jsonOf(someChart());
  ASSERT_EQ(json["points"].size(), 7U);
  EXPECT_EQ(json["points"][0]["seconds"]["median"], 0.012);
  EXPECT_EQ(json["points"][0]["seconds"]["runs"].size(), 3U);
  EXPECT_EQ(json["points"][1]["mismatches"]["unexplained"], 2);
  EXPECT_FALSE(json["points"][2].contains("mismatches"));
  EXPECT_EQ(json["reference"]["samples"], 128);
  EXPECT_EQ(json["reference"]["filters"][1]["band"], 0.002);
  EXPECT_EQ(json["methods"].size(), 2U);
  ASSERT_EQ(json["slopes"].size(), 2U);  // a peer of one point has none
  EXPECT_NEAR(json["slopes"][0]["slope"].get<double>(), -0.5, 1e-9);
}

TEST(ChartCsv, HasALineOfAsManyFieldsForEachPoint) {
  std::istringstream lines(csvOf(someChart()));
  std::size_t count = 0, fields = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    std::size_t commas = 0;
    bool inside = false;
    for (const char c : line) {
      inside = inside != (c == '"');
      commas += c == ',' && !inside ? 1 : 0;
    }
    if (count == 0) fields = commas;
    EXPECT_EQ(commas, fields) << line;
  }
  EXPECT_EQ(count, 8U);
}

TEST(ChartPage, IsOneWellFormedFileThatAsksForNoOther) {
  const std::string html = pageOf(someChart(), "relmse");
  pugi::xml_document document;
  const auto result = document.load_string(html.c_str(), pugi::parse_full);
  ASSERT_TRUE(result) << result.description() << " at "
                      << html.substr(static_cast<std::size_t>(result.offset), 80);
  for (const char* outside : {"<script", "https:", "@import", "url("})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  for (const auto& found : document.select_nodes("//img"))
    EXPECT_EQ(std::string(found.node().attribute("src").value()).rfind("data:", 0), 0U);
  // What each link leads to is there.
  std::size_t links = 0;
  for (const auto& found : document.select_nodes("//a")) {
    const std::string target = found.node().attribute("href").value();
    ASSERT_EQ(target.rfind('#', 0), 0U);
    EXPECT_TRUE(document.select_node(("//tr[@id='" + target.substr(1) + "']").c_str())) << target;
    ++links;
  }
  EXPECT_GT(links, 20U);
  // Two panels for each metric and filter, three of methods.
  EXPECT_EQ(document.select_nodes("//svg").size(), 2U * 3U * 2U + 3U);
  EXPECT_EQ(
      std::string(
          document.select_node("//input[@name='metric'][@checked]").node().attribute("id").value()),
      "metric-relmse");
}

TEST(ChartPanel, HoldsThePointsOfItsFilterAndMetric) {
  const Chart chart = someChart();
  const Panel a = timePanel(chart, 0, "rmse", false);
  ASSERT_EQ(a.curves.size(), 2U);
  EXPECT_EQ(a.curves[0].marks.size(), 3U);
  EXPECT_EQ(a.curves[0].marks[0].x, 0.012);
  EXPECT_EQ(a.curves[0].marks[0].low, 0.011);
  EXPECT_EQ(a.curves[0].marks[0].high, 0.016);
  EXPECT_EQ(a.slopes, (std::vector<double>{-0.5, -0.75}));
  ASSERT_EQ(a.levels.size(), 2U);
  EXPECT_EQ(a.levels[0].y, 0.001);
  EXPECT_EQ(a.levels[1].y, 1e-6);
  EXPECT_EQ(timePanel(chart, 0, "rmse", true).curves[0].marks[0].x, 0.31);
  const Panel unexplained = timePanel(chart, 1, "unexplained", false);
  ASSERT_EQ(unexplained.curves.size(), 1U);
  EXPECT_EQ(unexplained.curves[0].marks[0].y, 0.0);
  EXPECT_EQ(unexplained.curves[0].marks[1].y, 0.02);
  EXPECT_TRUE(std::isnan(unexplained.curves[0].marks[2].y));
  // A curve keeps its colour from panel to panel.
  EXPECT_EQ(unexplained.curves[0].colour, a.curves[0].colour);
}

TEST(ChartPanel, DrawsNothingWithoutPoints) {
  Chart chart = someChart();
  chart.points.clear();
  chart.methods.clear();
  EXPECT_GT(bitmapOf(chart, "rmse").width, 0);
  EXPECT_FALSE(pageOf(chart, "rmse").empty());
}

TEST(ChartRaster, FillsWhatAPolygonCovers) {
  RasterCanvas canvas(20, 10);
  canvas.moveTo({2, 0});
  const glm::dvec2 box[] = {{1, 1}, {9, 1}, {9, 5.5}, {1, 5.5}};
  canvas.polygon(box, {0, 0, 0}, 1.0);
  Bitmap bitmap = canvas.bitmap();
  EXPECT_EQ(bitmap.at(2, 3)[0], 255);
  EXPECT_EQ(bitmap.at(3, 3)[0], 0);
  EXPECT_EQ(bitmap.at(10, 3)[0], 0);
  EXPECT_EQ(bitmap.at(11, 3)[0], 255);
  EXPECT_NEAR(bitmap.at(5, 5)[0], 128, 30);
  EXPECT_EQ(bitmap.at(5, 6)[0], 255);
}

TEST(ChartRaster, EveryLetterOfTheChartHasStrokes) {
  for (const char letter :
       std::string("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz.,:;-+/()%^=*<>"))
    EXPECT_FALSE(strokesOf(letter).empty()) << letter;
  EXPECT_TRUE(strokesOf(' ').empty());
}

}  // namespace
}  // namespace laver::chart
