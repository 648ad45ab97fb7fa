#include <fmt/format.h>

#include <filesystem>

#include "core/numeric.h"
#include "image/atomic_file.h"
#include "image/io.h"
#include "lab/chart/chart.h"
#include "lab/chart/numbers.h"
#include "lab/chart/page.h"
#include "lab/chart/panel.h"

namespace laver::chart {
namespace {

nlohmann::json spread(const std::vector<double>& seconds) {
  return {{"median", quantile(seconds, 0.5)},
          {"quartiles", {quantile(seconds, 0.25), quantile(seconds, 0.75)}},
          {"runs", seconds}};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

nlohmann::json jsonOf(const Chart& chart) {
  auto points = nlohmann::json::array(), methods = points, truths = points, slopes = points;
  for (const Point& p : chart.points) {
    nlohmann::json entry{{"series", p.series},
                         {"program", p.program},
                         {"filter", p.filter->name},
                         {"sampler", p.sampler},
                         {"adaptive", p.adaptive},
                         {"traversal", p.traversal},
                         {"samples", p.samples},
                         {"command", p.command},
                         {"seconds", spread(p.passSeconds)},
                         {"processSeconds", spread(p.processSeconds)},
                         {"rmse", p.errors.rmse},
                         {"relativeMse", p.errors.relativeMse}};
    if (p.mismatches)
      entry["mismatches"] = {{"pixels", p.mismatches->pixels},
                             {"unexplained", p.mismatches->unexplained},
                             {"rmse", p.mismatches->rmse}};
    points.push_back(std::move(entry));
  }
  for (std::size_t f = 0; f < chart.truths.size(); ++f)
    truths.push_back({{"filter", chart.filters[f].row->name},
                      {"band", chart.truths[f].band},
                      {"relativeBand", chart.truths[f].relativeBand}});
  for (const auto& [series, slope] : slopesOf(chart))
    slopes.push_back({{"series", series}, {"slope", slope}});
  for (const MethodPoint& m : chart.methods) methods.push_back(toJson(m));
  return {{"scene", chart.scene},
          {"laver", LAVER_VERSION},
          {"width", chart.width},
          {"height", chart.height},
          {"machine", chart.machine},
          {"device", chart.device},
          {"driver", chart.driver},
          {"date", chart.date},
          {"reference", {{"samples", 2 * chart.truthSamples}, {"filters", truths}}},
          {"floatFloor", chart.floatFloor},
          {"slopes", slopes},
          {"points", points},
          {"methods", methods}};
}

std::string csvOf(const Chart& chart) {
  std::string csv =
      "series,program,filter,sampler,adaptive,traversal,samples,seconds,seconds_q1,seconds_q3,"
      "process_seconds,process_q1,process_q3,rmse,relative_mse,mismatches,unexplained\n";
  for (const Point& p : chart.points) {
    csv += fmt::format("{},{},{},{},{},{},{:g}", quoted(p.series), quoted(p.program),
                       p.filter->name, p.sampler, p.adaptive ? 1 : 0, p.traversal, p.samples);
    for (const auto* seconds : {&p.passSeconds, &p.processSeconds})
      csv += fmt::format(",{:.6g},{:.6g},{:.6g}", quantile(*seconds, 0.5), quantile(*seconds, 0.25),
                         quantile(*seconds, 0.75));
    csv += fmt::format(",{:.6g},{:.6g},", p.errors.rmse, p.errors.relativeMse);
    csv += p.mismatches ? fmt::format("{},{}\n", p.mismatches->pixels, p.mismatches->unexplained)
                        : ",\n";
  }
  return csv;
}

std::vector<std::pair<std::string, double>> slopesOf(const Chart& chart) {
  std::vector<std::pair<std::string, double>> slopes;
  std::vector<Place> places;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const Point& p = chart.points[i];
    places.push_back({p.samples, p.errors.rmse});
    if (i + 1 < chart.points.size() && chart.points[i + 1].series == p.series) continue;
    if (const double slope = logSlope(places); slope == slope) slopes.emplace_back(p.series, slope);
    places.clear();
  }
  return slopes;
}

Bitmap bitmapOf(const Chart& chart, const std::string& metric) {
  std::vector<Panel> panels{timePanel(chart, 0, metric, false), timePanel(chart, 0, metric, true)};
  if (chart.filters.size() > 1) panels.push_back(timePanel(chart, 1, metric, false));
  if (!chart.methods.empty()) panels.push_back(methodPanel(chart, "t"));
  const int rows = static_cast<int>(panels.size() + 1) / 2;
  RasterCanvas canvas(2 * kPanelWidth, rows * kPanelHeight + 26);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t row = i / 2;
    canvas.moveTo(
        {static_cast<double>(i % 2) * kPanelWidth, static_cast<double>(row) * kPanelHeight});
    draw(panels[i], canvas);
  }
  canvas.moveTo({0, rows * kPanelHeight});
  canvas.text(
      {14, 12},
      fmt::format("{}, {}x{}; {}; {}", std::filesystem::path(chart.scene).filename().string(),
                  chart.width, chart.height, chart.machine, chart.date),
      12.5, Anchor::Left, {90, 90, 90}, false);
  return canvas.bitmap();
}

void writeChart(const Chart& chart, const Options& options) {
  const auto put = [&](const char* name, const std::string& text) {
    replaceFile((std::filesystem::path(options.folder) / name).string(),
                std::as_bytes(std::span(text)));
  };
  put("chart.json", jsonOf(chart).dump(1) + '\n');
  put("chart.csv", csvOf(chart));
  put("chart.html", pageOf(chart, options.metric));
  writePng((std::filesystem::path(options.folder) / "chart.png").string(),
           bitmapOf(chart, options.metric), PngContent::Drawing);
}

}  // namespace laver::chart
