// The panels of a chart: what stands where.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/numeric.h"
#include "lab/chart/panel.h"

namespace laver::chart {
namespace {

/// The first six are told apart by those who see no red or no green (Okabe and Ito, "Color
/// Universal Design", 2008). To them the seventh looks like the second: marks differ in shape too.
constexpr Rgb8 kPalette[] = {{0, 114, 178}, {213, 94, 0},   {0, 158, 115}, {204, 121, 167},
                             {0, 0, 0},     {86, 180, 233}, {170, 130, 0}, {110, 110, 110},
                             {100, 0, 130}, {140, 200, 60}};

/// A curve's name, the same for all filters: its colour goes by it.
std::string lineOf(const Point& point) {
  std::string name = point.program == "laver" ? "" : point.program;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) name += (name.empty() ? "" : ", ") + part;
  };
  add(point.sampler);
  if (point.adaptive) add("adaptive");
  add(point.traversal);
  return name;
}

Shape shapeOf(const Point& point) {
  if (point.program != "laver") return Shape::Triangle;
  if (point.adaptive) return Shape::Diamond;
  return point.traversal.empty() ? Shape::Disc : Shape::Square;
}

std::string milliseconds(double seconds) { return fmt::format("{:.3g} ms", seconds * 1e3); }

}  // namespace

std::string anchorOf(std::size_t point) { return fmt::format("point-{}", point); }
std::string methodAnchor(std::size_t method) { return fmt::format("method-{}", method); }

double valueOf(const Point& point, const Chart& chart, const std::string& metric) {
  if (metric == "rmse") return point.errors.rmse;
  if (metric == "relmse") return point.errors.relativeMse;
  if (!point.mismatches) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(point.mismatches->unexplained) /
         (static_cast<double>(chart.width) * chart.height);
}

Panel timePanel(const Chart& chart, std::size_t filter, const std::string& metric, bool process) {
  const FilterRow* row = chart.filters[filter].row;
  Panel panel;
  panel.title = fmt::format("{}, {} filter",
                            process ? "B: whole process" : "A: trace + reconstruct", row->name);
  panel.xLabel = "seconds, median and quartiles";
  for (const Metric& m : kMetrics)
    if (metric == m.name) panel.yLabel = m.label;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const Point& point = chart.points[i];
    const std::string line = lineOf(point);
    auto place = std::find(lines.begin(), lines.end(), line);
    if (place == lines.end()) place = lines.insert(lines.end(), line);
    if (point.filter != row) continue;
    auto curve = std::find_if(panel.curves.begin(), panel.curves.end(),
                              [&](const Curve& c) { return c.label == line; });
    if (curve == panel.curves.end()) {
      const auto colour = static_cast<std::size_t>(place - lines.begin()) % std::size(kPalette);
      curve = panel.curves.insert(curve, {line, kPalette[colour], shapeOf(point), {}, true});
    }
    const auto& seconds = process ? point.processSeconds : point.passSeconds;
    const double x = quantile(seconds, 0.5), y = valueOf(point, chart, metric);
    const std::string samples =
        point.samples > 0 ? fmt::format("{:g}", std::round(point.samples * 10.0) / 10.0) : "";
    curve->marks.push_back({x, quantile(seconds, 0.25), quantile(seconds, 0.75), y, anchorOf(i),
                            fmt::format("{}{}: {}, {} {:.3g}", point.series,
                                        samples.empty() ? "" : ", " + samples + " samples a pixel",
                                        milliseconds(x), metric, y),
                            samples});
  }
  if (metric == "unexplained") return panel;
  panel.slopes = {-0.5, -0.75};
  const Truth& truth = chart.truths[filter];
  const bool relative = metric == "relmse";
  if (relative) panel.slopes.clear();  // squares: the slopes double, and the lines are of RMSE
  panel.levels.push_back(
      {relative ? truth.relativeBand : truth.band, "the reference's own error", true});
  if (!relative) panel.levels.push_back({chart.floatFloor, "float floor", false});
  return panel;
}

Panel methodPanel(const Chart& chart, const std::string& quantity) {
  Panel panel;
  panel.title = "C: intersection without noise";
  panel.xLabel = "nanoseconds a ray, median and quartiles";
  panel.yLabel = quantity == "t"        ? "99th percentile of the error of t, ulp"
                 : quantity == "normal" ? "99th percentile of the error of the normal, 2^-24"
                                        : "unexplained answers, share of aimed rays";
  std::map<std::string, std::uint64_t> worst;  // by laver's boxes, of both forms of nodes
  std::uint64_t plain = 0;                     // of laver's triangles by plain slabs
  for (std::size_t i = 0; i < chart.methods.size(); ++i) {
    const MethodPoint& m = chart.methods[i];
    auto curve = std::find_if(panel.curves.begin(), panel.curves.end(),
                              [&](const Curve& c) { return c.label == m.triangles; });
    if (curve == panel.curves.end())
      curve = panel.curves.insert(curve, {m.triangles,
                                          kPalette[panel.curves.size() % std::size(kPalette)],
                                          Shape::Disc,
                                          {},
                                          false});
    const double share = static_cast<double>(m.unexplained) / static_cast<double>(m.rays);
    const double y = quantity == "t" ? m.t99 : quantity == "normal" ? m.normal99 : share;
    const std::string form = (m.boxes == "ours"           ? "o"
                              : m.boxes == "robust slabs" ? "r"
                                                          : "p") +
                             std::string(m.nodes == "32 bits" ? "" : "8");
    curve->marks.push_back(
        {m.nanoseconds, m.quartiles[0], m.quartiles[1], y, methodAnchor(i),
         fmt::format("{}, {}, {}: {:.3g} ns a ray, {} of {} aimed rays unexplained", m.triangles,
                     m.boxes, m.nodes, m.nanoseconds, m.unexplained, m.rays),
         form});
    if (m.boxes == "ours") worst[m.triangles] = std::max(worst[m.triangles], m.unexplained);
    if (m.boxes == "plain slabs" && m.triangles == "ours") plain = std::max(plain, m.unexplained);
  }
  panel.notes = {"boxes: p plain, r robust,", "o ours; 8: nodes of 8 bits"};
  if (chart.methods.empty()) return panel;
  panel.notes.push_back(fmt::format("unexplained of {} rays,", chart.methods[0].rays));
  panel.notes.emplace_back("by boxes o:");
  for (const Curve& curve : panel.curves)
    panel.notes.push_back(fmt::format("  {} {}", worst[curve.label], curve.label));
  panel.notes.push_back(fmt::format("by boxes p: {} ours", plain));
  return panel;
}

}  // namespace laver::chart
