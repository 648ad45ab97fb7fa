#include <fmt/format.h>

#include "lab/chart/canvas.h"

namespace laver::chart {
namespace {

std::string hex(Rgb8 c) { return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]); }

std::string pointList(std::span<const glm::dvec2> points) {
  std::string text;
  for (const glm::dvec2 p : points)
    text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", p.x, p.y);
  return text;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

void SvgCanvas::polygon(std::span<const glm::dvec2> corners, Rgb8 colour, double opacity) {
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"{}/>\n", pointList(corners), hex(colour),
                       opacity == 1.0 ? "" : fmt::format(" fill-opacity=\"{:.2g}\"", opacity));
}

void SvgCanvas::polyline(std::span<const glm::dvec2> points, double width, Rgb8 colour,
                         double dash) {
  body_ +=
      fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\"{}/>\n",
                  pointList(points), hex(colour), width,
                  dash == 0.0 ? "" : fmt::format(" stroke-dasharray=\"{:g}\"", dash));
}

void SvgCanvas::text(glm::dvec2 at, const std::string& words, double size, Anchor anchor,
                     Rgb8 colour, bool upwards) {
  constexpr const char* kAnchors[] = {"start", "middle", "end"};
  const std::string turn =
      upwards ? fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", at.x, at.y) : "";
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" text-anchor=\"{}\" "
      "fill=\"{}\"{}>{}</text>\n",
      at.x, at.y, size, kAnchors[static_cast<int>(anchor)], hex(colour), turn, escaped(words));
}

void SvgCanvas::beginLink(const std::string& target, const std::string& title) {
  body_ += fmt::format("<a href=\"#{}\"><title>{}</title>\n", escaped(target), escaped(title));
}

void SvgCanvas::endLink() { body_ += "</a>\n"; }

std::string SvgCanvas::svg(const std::string& label) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-label=\"{}\">\n{}</svg>\n",
      width_, height_, escaped(label), body_);
}

}  // namespace laver::chart
