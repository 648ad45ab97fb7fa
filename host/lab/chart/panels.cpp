#include "lab/chart/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/numeric.h"
#include "lab/chart/numbers.h"
#include "scene/samplers.h"

namespace laver::chart {
namespace {

/// Distinguishable also with red or green colour blindness (Okabe and Ito, "Color Universal
/// Design", 2008).
constexpr Colour kPalette[kMaxCurves] = {{0, 114, 178},   {213, 94, 0}, {0, 158, 115},
                                         {204, 121, 167}, {0, 0, 0},    {86, 180, 233}};

/// laver's curves take colours from the front, peers' from the back, so that a peer has the same
/// colour in each panel.
struct Style {
  Colour colour;
  Shape shape;
};
Style laverStyle(std::size_t number, Shape shape) { return {kPalette[number % kMaxCurves], shape}; }
Style peerStyle(std::size_t number) {
  return {kPalette[kMaxCurves - 1 - number % kMaxCurves], Shape::Triangle};
}

/// The curve of a series; `seconds` selects the times of the pass or of the whole process.
Curve curveOf(const Series& series, const std::string& name, Style style,
              std::vector<double> Point::*seconds) {
  Curve curve{name, style.colour, style.shape, true, {}};
  for (const Point& point : series.points) {
    const auto ms = [&](double q) { return 1e3 * quantile(point.*seconds, q); };
    const double samples = std::round(point.samples * 10.0) / 10.0;
    curve.marks.push_back({ms(0.5), ms(0.25), ms(0.75), point.errors.rmse,
                           samples > 0 ? fmt::format("{:g}", samples) : ""});
  }
  return curve;
}

Panel errorPanel(const std::string& title, const std::string& time, const Chart& chart) {
  return {title, time + ", milliseconds", "error (RMSE; white is 1)", {}, chart.truthError};
}

Panel samplerPanel(const Chart& chart) {
  Panel panel = errorPanel("Which sampler is best?", "rendering alone", chart);
  for (const Series& series : chart.series) {
    if (series.program != "laver" || !series.traversal.empty()) continue;
    panel.curves.push_back(
        curveOf(series, series.name,
                laverStyle(panel.curves.size(), series.adaptive ? Shape::Diamond : Shape::Disc),
                &Point::passSeconds));
  }
  return panel;
}

std::string traversalText(const std::string& traversal) {
  return traversal == "lane" ? "laver, single rays"
                             : fmt::format("laver, packets of {} rays", traversal.substr(6));
}

/// The sampler `independent`, by all traversals and peers.
Panel traversalPanel(const Chart& chart) {
  Panel panel = errorPanel("Independent samples, traced in other ways", "rendering alone", chart);
  std::size_t laver = 0, peers = 0;
  for (const Series& series : chart.series) {
    if (series.sampler != samplers::independent.name || series.adaptive) continue;
    const bool own = series.program == "laver";
    const std::string& traversal = series.traversal.empty() ? chart.traversal : series.traversal;
    panel.curves.push_back(
        curveOf(series, own ? traversalText(traversal) : series.name,
                own ? laverStyle(laver++, series.traversal.empty() ? Shape::Disc : Shape::Square)
                    : peerStyle(peers++),
                &Point::passSeconds));
  }
  return panel;
}

/// laver's samplers without adaptive sampling, and peers.
Panel processPanel(const Chart& chart) {
  Panel panel = errorPanel("From the start of the program to the file",
                           "whole program, compiling included", chart);
  std::size_t number = 0, peers = 0;
  for (const Series& series : chart.series) {
    const bool own = series.program == "laver";
    if (own && (series.adaptive || !series.traversal.empty())) continue;
    const Style style = own ? laverStyle(number++, Shape::Disc) : peerStyle(peers++);
    panel.curves.push_back(curveOf(series, own ? "laver, " + series.name : series.name, style,
                                   &Point::processSeconds));
  }
  return panel;
}

/// One curve per triangle test, with a mark for each box test and node format.
Panel methodPanel(const Chart& chart) {
  Panel panel{"Ways to intersect a ray with a triangle",
              "time per ray, nanoseconds",
              "rounding error of the distance, ulp",
              {},
              0};
  std::vector<std::string> names;
  std::vector<std::uint64_t> wrong;
  for (const MethodPoint& m : chart.methods) {
    const auto found = std::find(names.begin(), names.end(), m.triangles);
    const auto i = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) {
      names.push_back(m.triangles);
      wrong.push_back(0);
      const Style style = laverStyle(i, Shape::Disc);
      panel.curves.push_back({"", style.colour, style.shape, false, {}});
    }
    wrong[i] = std::max(wrong[i], m.unexplained);
    panel.curves[i].marks.push_back({m.nanoseconds, m.quartiles[0], m.quartiles[1], m.t99, ""});
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    panel.curves[i].name = fmt::format(
        "{} ({:.2g} % wrong)", names[i],
        100.0 * static_cast<double>(wrong[i]) / static_cast<double>(chart.methods[0].rays));
  return panel;
}

std::vector<std::string> notesOf(const Chart& chart) {
  std::uint64_t pixels = 0, unexplained = 0;
  for (const Series& series : chart.series)
    for (const Point& point : series.points)
      if (point.mismatches) {
        pixels += point.mismatches->pixels;
        unexplained += point.mismatches->unexplained;
      }
  std::vector<std::string> notes;
  notes.push_back(fmt::format(
      "Exact picture: {}, {} samples per pixel; its own error is {:.2g}. Against the "
      "double-precision picture of the same samples, {} pixels differ visibly, {} of them for "
      "another reason than rounding at an edge{}.",
      chart.truthOrigin, 2 * chart.truthSamples, chart.truthError, pixels, unexplained,
      chart.paths ? " that the camera sees, such as at the next edge of a path" : ""));
  if (!chart.methods.empty())
    notes.push_back(fmt::format(
        "Ray-triangle tests, each with three box tests and two node formats: the 99th percentile "
        "of "
        "the distance's error, in units in the last place. Wrong: of {} rays aimed at edges and "
        "corners, the largest share that find another triangle or none.",
        chart.methods[0].rays));
  for (const std::string& peer : chart.missing) notes.push_back("Not measured: " + peer + ".");
  notes.push_back(fmt::format("Medians and quartiles. {}; {}; laver {}, {}.", chart.machine,
                              chart.device, LAVER_VERSION, chart.date));
  return notes;
}

}  // namespace

Figure figureOf(const Chart& chart) {
  Figure figure;
  figure.title =
      "Speed against accuracy: " + std::filesystem::path(chart.scene).filename().string();
  figure.introduction = {fmt::format(
      "Each mark is one way to render the same picture of {} x {} pixels: further left is "
      "faster, further down is closer to the exact picture. The number beside a mark is "
      "the samples (camera rays) per pixel. A sampler chooses where in a pixel they lie; "
      "an adaptive one gives more samples to noisy pixels.",
      chart.width, chart.height)};
  for (Panel& panel : std::vector{samplerPanel(chart), traversalPanel(chart), processPanel(chart),
                                  methodPanel(chart)})
    if (!panel.curves.empty()) figure.panels.push_back(std::move(panel));
  figure.notes = notesOf(chart);
  return figure;
}

}  // namespace laver::chart
