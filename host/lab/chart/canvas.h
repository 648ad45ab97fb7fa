#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "image/bitmap.h"

namespace laver::chart {

enum class Anchor { Left, Middle, Right };

/// What a panel is drawn on; lengths in pixels from the top left.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void polygon(std::span<const glm::dvec2> corners, Rgb8 colour, double opacity) = 0;
  /// `dash`: lengths of dashes and gaps; 0: a line without gaps.
  virtual void polyline(std::span<const glm::dvec2> points, double width, Rgb8 colour,
                        double dash) = 0;
  /// Baseline at `at`; `upwards` turns it by a quarter.
  virtual void text(glm::dvec2 at, const std::string& words, double size, Anchor anchor,
                    Rgb8 colour, bool upwards) = 0;
  /// What is drawn until the end of it leads to a place of the page and explains itself.
  virtual void beginLink(const std::string& target, const std::string& title) = 0;
  virtual void endLink() = 0;
};

/// Text of an inline <svg> element.
class SvgCanvas : public Canvas {
 public:
  SvgCanvas(int width, int height) : width_(width), height_(height) {}
  void polygon(std::span<const glm::dvec2> corners, Rgb8 colour, double opacity) override;
  void polyline(std::span<const glm::dvec2> points, double width, Rgb8 colour,
                double dash) override;
  void text(glm::dvec2 at, const std::string& words, double size, Anchor anchor, Rgb8 colour,
            bool upwards) override;
  void beginLink(const std::string& target, const std::string& title) override;
  void endLink() override;
  std::string svg(const std::string& label) const;

 private:
  int width_, height_;
  std::string body_;
};

/// A bitmap, antialiased; letters are drawn as lines.
class RasterCanvas : public Canvas {
 public:
  RasterCanvas(int width, int height);
  /// Moves what is drawn next.
  void moveTo(glm::dvec2 origin) { origin_ = origin; }
  void polygon(std::span<const glm::dvec2> corners, Rgb8 colour, double opacity) override;
  void polyline(std::span<const glm::dvec2> points, double width, Rgb8 colour,
                double dash) override;
  void text(glm::dvec2 at, const std::string& words, double size, Anchor anchor, Rgb8 colour,
            bool upwards) override;
  void beginLink(const std::string&, const std::string&) override {}
  void endLink() override {}
  const Bitmap& bitmap() const { return bitmap_; }

 private:
  void cover(int x, int y, double share, Rgb8 colour);
  Bitmap bitmap_;
  glm::dvec2 origin_{0.0};
};

/// Lines of a letter, one behind the other, in units of its size: x from 0, y up from the baseline.
std::vector<std::vector<glm::dvec2>> strokesOf(char letter);
/// How far the next letter is on, in units of the size.
inline constexpr double kAdvance = 0.6;

/// Text of an element or attribute in XML.
std::string escaped(const std::string& text);

}  // namespace laver::chart
