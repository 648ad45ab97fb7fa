#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/numeric.h"
#include "lab/chart/chart.h"
#include "lab/chart/panels.h"

namespace laver::chart {
namespace {

nlohmann::json spread(const std::vector<double>& seconds) {
  return {{"median", quantile(seconds, 0.5)},
          {"quartiles", {quantile(seconds, 0.25), quantile(seconds, 0.75)}},
          {"runs", seconds}};
}

nlohmann::json jsonOf(const Point& point) {
  nlohmann::json json{{"samples", point.samples},
                      {"command", point.command},
                      {"seconds", spread(point.passSeconds)},
                      {"processSeconds", spread(point.processSeconds)},
                      {"rmse", point.errors.rmse},
                      {"relativeMse", point.errors.relativeMse}};
  if (point.mismatches)
    json["mismatches"] = {{"pixels", point.mismatches->pixels},
                          {"unexplained", point.mismatches->unexplained},
                          {"rmse", point.mismatches->rmse}};
  return json;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

nlohmann::json jsonOf(const Chart& chart) {
  auto series = nlohmann::json::array(), methods = series;
  for (const Series& each : chart.series) {
    auto points = nlohmann::json::array();
    for (const Point& point : each.points) points.push_back(jsonOf(point));
    series.push_back({{"name", each.name},
                      {"program", each.program},
                      {"sampler", each.sampler},
                      {"adaptive", each.adaptive},
                      {"traversal", each.traversal},
                      {"points", points}});
  }
  for (const MethodPoint& m : chart.methods) methods.push_back(toJson(m));
  return {{"scene", chart.scene},
          {"laver", LAVER_VERSION},
          {"width", chart.width},
          {"height", chart.height},
          {"machine", chart.machine},
          {"device", chart.device},
          {"driver", chart.driver},
          {"date", chart.date},
          {"reference",
           {{"samples", 2 * chart.truthSamples},
            {"rmse", chart.truthError},
            {"origin", chart.truthOrigin}}},
          {"series", series},
          {"missing", chart.missing},
          {"methods", methods}};
}

std::string csvOf(const Chart& chart) {
  std::string csv =
      "series,program,sampler,adaptive,traversal,samples,seconds,seconds_q1,seconds_q3,"
      "process_seconds,process_q1,process_q3,rmse,relative_mse,mismatches,unexplained\n";
  for (const Series& each : chart.series)
    for (const Point& p : each.points) {
      csv += fmt::format("{},{},{},{},{},{:g}", quoted(each.name), quoted(each.program),
                         each.sampler, each.adaptive ? 1 : 0, each.traversal, p.samples);
      for (const auto* seconds : {&p.passSeconds, &p.processSeconds})
        csv += fmt::format(",{:.6g},{:.6g},{:.6g}", quantile(*seconds, 0.5),
                           quantile(*seconds, 0.25), quantile(*seconds, 0.75));
      csv += fmt::format(",{:.6g},{:.6g},", p.errors.rmse, p.errors.relativeMse);
      csv += p.mismatches ? fmt::format("{},{}\n", p.mismatches->pixels, p.mismatches->unexplained)
                          : ",\n";
    }
  return csv;
}

void writeChart(const Chart& chart, const std::string& folder) {
  const auto put = [&](const char* name, const std::string& text) {
    replaceFile((std::filesystem::path(folder) / name).string(), std::as_bytes(std::span(text)));
  };
  const Figure figure = figureOf(chart);
  put("chart.svg", svgOf(figure));
  put("chart.png", pngOf(figure, 1.5));
  put("chart.csv", csvOf(chart));
  put("chart.json", jsonOf(chart).dump(1) + '\n');
}

}  // namespace laver::chart
