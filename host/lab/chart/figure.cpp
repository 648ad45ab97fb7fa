#include "lab/chart/figure.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>

#include "core/error.h"

namespace laver::chart {
namespace {

using glm::dvec2;

constexpr double kHead = 18, kText = 12, kLine = 17, kMargin = 8;

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Cairo = std::unique_ptr<cairo_t, Destroy>;

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ExitCode::Output, std::string("cairo: ") + cairo_status_to_string(status));
}

cairo_status_t append(void* text, const unsigned char* data, unsigned size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void setColour(cairo_t* cairo, Colour colour) {
  cairo_set_source_rgb(cairo, colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

void setFont(cairo_t* cairo, double size, bool bold) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
}

void drawText(cairo_t* cairo, dvec2 at, const std::string& text, double size, bool bold,
              Colour colour) {
  setFont(cairo, size, bold);
  setColour(cairo, colour);
  cairo_move_to(cairo, at.x, at.y);
  cairo_show_text(cairo, text.c_str());
  cairo_new_path(cairo);  // otherwise a path starts at the text's end
}

void drawSymbol(cairo_t* cairo, const Symbol& symbol) {
  const bool square = symbol.shape == Shape::Square;
  const int corners = symbol.shape == Shape::Triangle ? 3 : 4;
  if (symbol.shape == Shape::Disc)
    cairo_arc(cairo, symbol.at.x, symbol.at.y, kSymbolRadius, 0.0, 2.0 * std::numbers::pi);
  for (int i = 0; symbol.shape != Shape::Disc && i < corners; ++i) {
    const double angle = std::numbers::pi * ((square ? 0.25 : 0.5) + 2.0 * i / corners);
    const dvec2 p = symbol.at + kSymbolRadius * 1.15 * dvec2(std::cos(angle), -std::sin(angle));
    cairo_line_to(cairo, p.x, p.y);
  }
  cairo_close_path(cairo);
  setColour(cairo, symbol.colour);
  cairo_fill(cairo);
}

void drawLabel(cairo_t* cairo, const Label& label) {
  cairo_save(cairo);
  cairo_translate(cairo, label.at.x, label.at.y);
  if (label.upwards) cairo_rotate(cairo, -0.5 * std::numbers::pi);
  drawText(cairo, {0, 0}, label.text, label.size, label.bold, label.colour);
  cairo_restore(cairo);
}

void drawPanel(cairo_t* cairo, const Layout& layout) {
  for (const Rect& shade : layout.shades) {
    cairo_rectangle(cairo, shade.lo.x, shade.lo.y, shade.hi.x - shade.lo.x,
                    shade.hi.y - shade.lo.y);
    setColour(cairo, kShade);
    cairo_fill(cairo);
  }
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  for (const Stroke& stroke : layout.strokes) {
    for (const dvec2 p : stroke.points) cairo_line_to(cairo, p.x, p.y);
    cairo_set_line_width(cairo, stroke.width);
    setColour(cairo, stroke.colour);
    cairo_stroke(cairo);
  }
  for (const Symbol& symbol : layout.symbols) drawSymbol(cairo, symbol);
  for (const Label& label : layout.labels) drawLabel(cairo, label);
}

/// Breaks paragraphs into lines no wider than the figure.
std::vector<std::string> wrapped(const std::vector<std::string>& paragraphs) {
  std::vector<std::string> lines;
  for (const std::string& paragraph : paragraphs) {
    std::istringstream words(paragraph);
    std::string line;
    for (std::string word; words >> word;) {
      const std::string longer = line.empty() ? word : line + ' ' + word;
      if (!line.empty() && textWidth(longer, kText, false) > kFigureWidth - 2 * kMargin) {
        lines.push_back(line);
        line = word;
      } else {
        line = longer;
      }
    }
    lines.push_back(line);
  }
  return lines;
}

/// A figure after line breaking, with the positions of its parts.
struct Page {
  explicit Page(const Figure& figure)
      : introduction(wrapped(figure.introduction)), notes(wrapped(figure.notes)) {
    panelsTop = kLine + kHead + kLine * static_cast<double>(introduction.size()) + 8;
    const auto rows = static_cast<double>((figure.panels.size() + 1) / 2);
    notesTop = panelsTop + rows * kPanelSize.y;
    height = std::ceil(notesTop + kLine * static_cast<double>(notes.size()) + 10);
  }
  std::vector<std::string> introduction, notes;
  double panelsTop, notesTop, height;
};

void draw(const Figure& figure, const Page& page, cairo_t* cairo) {
  cairo_set_source_rgb(cairo, 1, 1, 1);
  cairo_paint(cairo);
  double y = kLine + 6;
  drawText(cairo, {kMargin, y}, figure.title, kHead, true, kInk);
  for (const std::string& line : page.introduction)
    drawText(cairo, {kMargin, y += kLine + 2}, line, kText, false, kInk);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    cairo_save(cairo);
    cairo_translate(cairo, static_cast<double>(i % 2) * kPanelSize.x,
                    page.panelsTop + static_cast<double>(i / 2) * kPanelSize.y);
    drawPanel(cairo, layoutOf(figure.panels[i], textWidth));
    cairo_restore(cairo);
  }
  y = page.notesTop;
  for (const std::string& line : page.notes)
    drawText(cairo, {kMargin, y += kLine}, line, kText, false, kGrey);
}

}  // namespace

double textWidth(const std::string& text, double size, bool bold) {
  const Surface surface(cairo_recording_surface_create(CAIRO_CONTENT_COLOR, nullptr));
  const Cairo cairo(cairo_create(surface.get()));
  setFont(cairo.get(), size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo.get(), text.c_str(), &extents);
  check(cairo_status(cairo.get()));
  return extents.x_advance;
}

std::string svgOf(const Figure& figure) {
  const Page page(figure);
  std::string svg;
  const Surface surface(
      cairo_svg_surface_create_for_stream(append, &svg, kFigureWidth, page.height));
  const Cairo cairo(cairo_create(surface.get()));
  draw(figure, page, cairo.get());
  check(cairo_status(cairo.get()));
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return svg;
}

std::string pngOf(const Figure& figure, double scale) {
  const Page page(figure);
  std::string png;
  const Surface surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(kFigureWidth * scale)),
      static_cast<int>(std::lround(page.height * scale))));
  const Cairo cairo(cairo_create(surface.get()));
  cairo_scale(cairo.get(), scale, scale);
  draw(figure, page, cairo.get());
  check(cairo_status(cairo.get()));
  check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  return png;
}

}  // namespace laver::chart
