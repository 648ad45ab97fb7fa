// The JSON and CSV files of a chart, and its series.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "lab/chart/chart.h"
#include "scene/samplers.h"

namespace laver::test {
namespace {

using namespace chart;

Chart someChart() {
  Chart chart;
  chart.scene = "folder/some scene.xml";
  chart.truthSamples = 64;
  chart.truthError = 0.001;
  chart.truthOrigin = "double precision";
  Series laver{"sobol", "laver", "sobol", false, "", {}};
  for (const int samples : {1, 4}) {
    Point point{
        1.0 * samples,    "laver ...",           {samples * 0.01, samples * 0.02, samples * 0.012},
        {0.3, 0.31, 0.5}, {0.1 / samples, 0.01}, {}};
    if (samples == 4) point.mismatches = Mismatches{5, 2, 1e-6};
    laver.points.push_back(point);
  }
  chart.series = {laver,
                  {"other, \"quoted\" <peer>", "p", "independent", false, "", {laver.points[0]}}};
  chart.missing = {"another: not installed"};
  chart.methods = {{"ours", "ours", "32 bits", 50, {49, 52}, 0.5, 1.0, 100, 0}};
  return chart;
}

TEST(ChartJson, HoldsEveryPointAndItsCommand) {
  const nlohmann::json json = jsonOf(someChart());
  ASSERT_EQ(json["series"].size(), 2U);
  const auto& points = json["series"][0]["points"];
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0]["seconds"]["median"], 0.012);
  EXPECT_EQ(points[0]["seconds"]["runs"].size(), 3U);
  EXPECT_FALSE(points[0].contains("mismatches"));
  EXPECT_EQ(points[1]["mismatches"]["unexplained"], 2);
  EXPECT_EQ(json["reference"]["samples"], 128);
  EXPECT_EQ(json["reference"]["origin"], "double precision");
  EXPECT_EQ(json["missing"][0], "another: not installed");
  EXPECT_EQ(json["methods"].size(), 1U);
}

TEST(ChartCsv, HasALineOfTheSameNumberOfFieldsPerPoint) {
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
  EXPECT_EQ(count, 4U);
}

const Series& find(const std::vector<Series>& all, const char* name) {
  return *std::find_if(all.begin(), all.end(), [&](const Series& s) { return s.name == name; });
}

TEST(ChartSeries, EverySamplerIsChartedAndAdaptivelyWhereItCan) {
  const auto all = seriesFor("packet32", {{"peer", {"command"}}});
  std::set<std::string> names;
  for (const Series& series : all) EXPECT_TRUE(names.insert(series.name).second) << series.name;
  for (const SamplerRow* row : samplerRows()) {
    EXPECT_TRUE(names.contains(row->name));
    EXPECT_EQ(names.contains(std::string(row->name) + ", adaptive"), row->adaptive) << row->name;
  }
  EXPECT_TRUE(names.contains("independent, lane"));
  EXPECT_TRUE(names.contains("independent, packet64"));
  EXPECT_TRUE(names.contains("peer"));
  EXPECT_FALSE(names.contains("independent, packet32"));  // laver's choice
  for (const Series& series : seriesFor("lane", {})) EXPECT_EQ(series.traversal, "") << series.name;
}

TEST(ChartSeries, StepsTakeFourTimesTheSamplesOrHalfTheError) {
  using Options = std::vector<std::string>;
  const auto all = seriesFor("packet32", {});
  const Series& sobol = find(all, "sobol");
  EXPECT_EQ(stepOptions(sobol, 0, 20), (Options{"--sampler", "sobol", "--spp", "1"}));
  EXPECT_EQ(stepOptions(sobol, 2, 20), (Options{"--sampler", "sobol", "--spp", "16"}));
  EXPECT_TRUE(stepOptions(sobol, 3, 20).empty());
  EXPECT_EQ(stepOptions(find(all, "independent, lane"), 1, 20),
            (Options{"--sampler", "independent", "--spp", "4", "--traversal", "lane"}));
  const Series& adaptive = find(all, "sobol, adaptive");
  EXPECT_EQ(stepOptions(adaptive, 1, 20),
            (Options{"--sampler", "sobol", "--error", "0.02", "--spp", "1024"}));
  EXPECT_TRUE(stepOptions(adaptive, 4, 20).empty());
}

}  // namespace
}  // namespace laver::test
