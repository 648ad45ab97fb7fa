#include "lab/chart/page.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/numeric.h"
#include "lab/chart/panel.h"

namespace laver::chart {
namespace {

constexpr const char* kStyle = R"(
body { font: 15px/1.5 system-ui, sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem; color: #282828 }
svg { width: 100%; height: auto; font-family: system-ui, sans-serif }
svg a:hover polygon { stroke: #282828; stroke-width: 2 }
table { border-collapse: collapse; margin: 1rem 0 }
th, td { padding: .25rem .6rem; border-bottom: 1px solid #ddd; text-align: right; vertical-align: middle }
th:first-child, td:first-child, .text { text-align: left }
tr:target { background: #fff3c4 }
img { display: block; width: 96px; image-rendering: pixelated }
code { font-size: 12px; overflow-wrap: anywhere }
label { padding: .15rem .6rem; border: 1px solid #bbb; border-radius: .4rem; cursor: pointer }
.choice, .shown > * { display: none }
.scale { height: 14px; width: 220px; display: inline-block; vertical-align: middle;
  background: linear-gradient(90deg, #440154, #3b528b, #21918c, #5ec962, #fde725) }
)";

/// A group of radio buttons that stand before what they show or hide, which needs no script.
struct Choices {
  std::string group;
  std::vector<std::pair<std::string, std::string>> names;  ///< class and words
  std::size_t first = 0;

  std::string inputs() const {
    std::string html;
    for (std::size_t i = 0; i < names.size(); ++i)
      html += fmt::format("<input class=\"choice\" type=\"radio\" name=\"{}\" id=\"{}-{}\"{}/>\n",
                          group, group, names[i].first, i == first ? " checked=\"checked\"" : "");
    return html;
  }
  std::string labels() const {
    std::string html;
    for (const auto& [name, words] : names)
      html += fmt::format("<label for=\"{}-{}\">{}</label> ", group, name, escaped(words));
    return html;
  }
  /// A button that is on looks so.
  std::string style() const {
    std::string css;
    for (const auto& [name, words] : names)
      css += fmt::format(
          "#{0}-{1}:checked ~ * label[for={0}-{1}] {{ background: #0072b2; color: #fff }}\n", group,
          name);
    return css;
  }
};

std::string drawn(const Panel& panel, const std::string& classes) {
  SvgCanvas canvas(kPanelWidth, kPanelHeight);
  draw(panel, canvas);
  return fmt::format("<div class=\"{}\">{}</div>\n", classes, canvas.svg(panel.title));
}

std::string milliseconds(const std::vector<double>& seconds) {
  return fmt::format("{:.3g}", quantile(seconds, 0.5) * 1e3);
}

std::string pointRow(const Chart& chart, std::size_t i) {
  const Point& p = chart.points[i];
  const Truth* truth = nullptr;
  for (std::size_t f = 0; f < chart.truths.size(); ++f)
    if (chart.filters[f].row == p.filter) truth = &chart.truths[f];
  const bool buried = truth != nullptr && p.errors.rmse < 2.0 * truth->band;
  return fmt::format(
      "<tr id=\"{}\"><td>{}{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}{:.3g}</td><td>{:.3g}</td>"
      "<td>{}</td><td><img alt=\"picture\" src=\"{}\"/></td><td><img alt=\"errors\" "
      "src=\"{}\"/></td></tr>\n",
      anchorOf(i), escaped(p.series),
      p.command.empty() ? "" : "<br/><code>" + escaped(p.command) + "</code>",
      p.samples > 0 ? fmt::format("{:.4g}", p.samples) : "", milliseconds(p.passSeconds),
      milliseconds(p.processSeconds), buried ? "about " : "", p.errors.rmse, p.errors.relativeMse,
      p.mismatches ? fmt::format("{} of {}", p.mismatches->unexplained, p.mismatches->pixels) : "",
      p.thumbnail, p.errorMap);
}

std::string methodTable(const Chart& chart) {
  std::string html =
      "<table><tr><th>triangles</th><th class=\"text\">boxes</th><th class=\"text\">nodes</th>"
      "<th>ns a ray</th><th>t, ulp</th><th>normal, "
      "2^-24</th><th>unexplained</th><th>rays</th></tr>\n";
  for (std::size_t i = 0; i < chart.methods.size(); ++i) {
    const MethodPoint& m = chart.methods[i];
    html += fmt::format(
        "<tr id=\"{}\"><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td>"
        "<td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td><td>{}</td><td>{}</td></tr>\n",
        methodAnchor(i), escaped(m.triangles), escaped(m.boxes), escaped(m.nodes), m.nanoseconds,
        m.t99, m.normal99, m.unexplained, m.rays);
  }
  return html + "</table>\n";
}

constexpr const char* kIntroduction =
    R"(<p>Each dot is one way to make the same picture. The further
<b>left</b> it stands, the sooner the picture was done; the <b>lower</b>, the closer it is to the
true one. A renderer follows rays of light through random points of each pixel, its
<i>samples</i>; the numbers beside the dots say how many. Four times the samples take about four
times as long. Where the samples are drawn without plan (<i>independent</i>) that halves the error:
the dashed line of slope -1/2. Samples that are spread evenly do better, at edges with slope -3/4.
The thick grey line joins the dots that no other beats both in time and in error. Click on a dot
for its picture.</p>
)";

constexpr const char* kExplanation =
    R"(<p>The true picture is rendered in double precision, by a program that
shares no code with what it judges, from {} samples a pixel in two halves. How far the halves are
apart tells how far it may still be off itself: the shaded band. Dots in the band could be better
than they look. The float floor is what is left of the error where both sides take the same
samples: the rounding of 32-bit numbers. Both are of the root mean square error (RMSE) over all
pixels and colours, in units of light where 1 is white; the relative error divides each
difference by the true value first. A <i>mismatch</i> is a pixel that differs by more than 1e-4 from the
double-precision picture of the same samples; it is explained where one of these passes an edge of
something so closely that rounding decides. Unexplained ones are mistakes. Each filter, the way samples are
shared among neighbouring pixels, has a true picture of its own.</p>
)";

constexpr const char* kMethods =
    R"(<p>The same rays through the same scene, without randomness: each dot is a
way to find the triangle that a ray hits. Time is for camera rays on the device, one ray at a time; errors of
the distance t and of the surface's direction are against exact arithmetic, in units of the last
place of a 32-bit number. Mismatches are counted on rays that are aimed at edges and corners, where careless
methods let rays slip through closed surfaces. All but <i>ours</i> exist only for this chart.</p>
)";

}  // namespace

std::string pageOf(const Chart& chart, const std::string& metric) {
  Choices metrics{
      "metric",
      {{"rmse", "RMSE"}, {"relmse", "relative MSE"}, {"unexplained", "unexplained mismatches"}}};
  for (std::size_t i = 0; i < metrics.names.size(); ++i)
    if (metrics.names[i].first == metric) metrics.first = i;
  Choices filters{"filter", {}, 0};
  for (const Filter& filter : chart.filters)
    filters.names.emplace_back(filter.row->name, std::string(filter.row->name) + " filter");
  Choices quantities{"quantity",
                     {{"t", "distance"}, {"normal", "direction"}, {"slips", "mismatches"}}};

  std::string style = std::string(kStyle) + metrics.style() + filters.style() + quantities.style();
  std::string panels, methods;
  for (const auto& [m, words] : metrics.names)
    for (std::size_t f = 0; f < filters.names.size(); ++f) {
      const std::string& filter = filters.names[f].first;
      style += fmt::format(
          "#metric-{0}:checked ~ #filter-{1}:checked ~ .shown > .{0}.{1} {{ display: block }}\n", m,
          filter);
      for (const bool process : {false, true})
        panels += drawn(timePanel(chart, f, m, process), fmt::format("{} {}", m, filter));
    }
  for (const auto& [quantity, words] : quantities.names) {
    style += fmt::format("#quantity-{0}:checked ~ .shown > .{0} {{ display: block }}\n", quantity);
    if (!chart.methods.empty()) methods += drawn(methodPanel(chart, quantity), quantity);
  }

  const std::string name = std::filesystem::path(chart.scene).filename().string();
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>laver chart: "
      "{}</title>\n<style>{}</style></head><body>\n<h1>Speed against accuracy: {}</h1>\n",
      escaped(name), style, escaped(name));
  html += kIntroduction;
  html += metrics.inputs() + filters.inputs();
  html += "<p>" + metrics.labels() + "</p><p>" + filters.labels() +
          "</p>\n<div class=\"shown\">\n" + panels + "</div>\n";
  html += fmt::format(kExplanation, 2 * chart.truthSamples);
  if (!methods.empty())
    html += std::string("<section>") + kMethods + quantities.inputs() + "<p>" +
            quantities.labels() + "</p>\n<div class=\"shown\">" + methods + "</div>" +
            methodTable(chart) + "</section>\n";
  html +=
      "<h2>All points</h2>\n<p>Times are medians in milliseconds. Colours of the error pictures, "
      "from 1e-4 to 1: <span class=\"scale\"></span></p>\n"
      "<table><tr><th>way</th><th>samples</th><th>trace + reconstruct</th><th>whole process</th>"
      "<th>RMSE</th><th>relative MSE</th><th>unexplained of mismatches</th><th>picture</th>"
      "<th>error</th></tr>\n";
  for (std::size_t i = 0; i < chart.points.size(); ++i) html += pointRow(chart, i);
  html +=
      "</table>\n<h2>How the error falls</h2>\n<table><tr><th>way</th><th>slope of RMSE over "
      "samples</th></tr>\n";
  for (const auto& [series, slope] : slopesOf(chart))
    html += fmt::format("<tr><td>{}</td><td>{:.2f}</td></tr>\n", escaped(series), slope);
  html += fmt::format(
      "</table>\n<p>{}, {} x {} pixels. {}; {} ({}). laver {}, {}.</p>\n</body></html>\n",
      escaped(chart.scene), chart.width, chart.height, escaped(chart.machine),
      escaped(chart.device), escaped(chart.driver), LAVER_VERSION, chart.date);
  return html;
}

}  // namespace laver::chart
