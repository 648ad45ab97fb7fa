#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base64.h"
#include "lab/suite/report.h"

namespace laver::suite {
namespace {

// Pictures of a few pixels are enlarged without smoothing.
constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>
body {{ font: 15px/1.4 sans-serif; margin: 2em; background: #fff; color: #222 }}
h1 {{ font-size: 1.3em }}
section {{ border-left: 6px solid #999; margin: 1em 0; padding: .2em 1em }}
section.failed {{ border-color: #c22 }}
section.passed {{ border-color: #2a7 }}
h2 {{ font-size: 1.05em; margin: .2em 0 }}
p, pre {{ margin: .3em 0; white-space: pre-wrap }}
figure {{ display: inline-block; margin: .3em 1em .3em 0; vertical-align: top }}
figcaption {{ color: #666; font-size: .85em }}
img {{ min-width: 240px; max-width: 30vw; image-rendering: pixelated; background: #ddd }}
</style></head><body>
<h1>{title}</h1>
<p>{summary}</p>
)";

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string pictureOf(const char* caption, const std::vector<std::byte>& png) {
  if (png.empty()) return {};
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">"
      "<figcaption>{0}</figcaption></figure>\n",
      caption, base64(png));
}

std::string sectionOf(const Result& result) {
  const std::string verdict = nameOf(result.verdict);
  std::string html = fmt::format("<section class=\"{0}\">\n<h2>{1}: {0}</h2>\n<p>{2:.2f} s",
                                 verdict, escaped(result.name), result.seconds);
  if (result.figure) html += "; " + escaped(result.figure->text);
  if (!result.change.empty()) html += "; expected picture " + escaped(result.change);
  html += "</p>\n";
  if (!result.reason.empty()) html += "<p>" + escaped(result.reason) + "</p>\n";
  html += pictureOf("actual", result.actual) + pictureOf("expected", result.expected) +
          pictureOf("difference", result.difference);
  if (!result.output.empty())
    html +=
        "<details><summary>output</summary><pre>" + escaped(result.output) + "</pre></details>\n";
  return html + "</section>\n";
}

/// The figure relative to its tolerance; without a figure, failed tests are the worst.
double severity(const Result& result) {
  constexpr double kWorst = std::numeric_limits<double>::infinity();
  if (!result.figure) return result.verdict == Verdict::Failed ? kWorst : 0.0;
  return result.figure->share;
}

/// Whether a is worse than b: failed before skipped before passed.
bool isWorse(const Result* a, const Result* b) {
  const auto rank = [](const Result& r) {
    return r.verdict == Verdict::Failed ? 0 : r.verdict == Verdict::Skipped ? 1 : 2;
  };
  if (rank(*a) != rank(*b)) return rank(*a) < rank(*b);
  return severity(*a) > severity(*b);
}

}  // namespace

std::string htmlOf(const std::vector<Result>& results, const std::string& folder) {
  std::vector<const Result*> order;
  order.reserve(results.size());
  for (const Result& result : results) order.push_back(&result);
  std::ranges::stable_sort(order, isWorse);
  std::string html =
      fmt::format(fmt::runtime(kHead), fmt::arg("title", "laver test " + escaped(folder)),
                  fmt::arg("summary", summaryOf(countsOf(results))));
  for (const Result* result : order) html += sectionOf(*result);
  return html + "</body></html>\n";
}

}  // namespace laver::suite
