#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace laver {

using Rgb8 = std::array<std::uint8_t, 3>;

/// An 8-bit sRGB image, row-major from the top left.
struct Bitmap {
  int width = 0;
  int height = 0;
  std::vector<Rgb8> pixels;

  Bitmap(int w, int h, Rgb8 colour)
      : width(w),
        height(h),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), colour) {}

  Rgb8& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  /// Fills the w x h pixels whose top left corner is (x, y); they must lie inside.
  void fill(int x, int y, int w, int h, Rgb8 colour) {
    for (int v = y; v < y + h; ++v)
      for (int u = x; u < x + w; ++u) at(u, v) = colour;
  }
};

/// Width and height in pixels of `text` in glyphs of 5 x 7 dots, each `dot` pixels wide and high.
int textWidth(const std::string& text, int dot);
int textHeight(int dot);

/// Draws `text` with its top left corner at (x, y); it must fit. There are glyphs for the digits
/// and the letters of "e-inf"; other characters are blank.
void drawText(Bitmap& bitmap, int x, int y, const std::string& text, int dot, Rgb8 colour);

}  // namespace laver
