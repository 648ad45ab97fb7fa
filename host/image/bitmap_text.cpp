#include <map>

#include "image/bitmap.h"

namespace laver {
namespace {

constexpr int kColumns = 5, kRows = 7, kAdvance = 6;

/// Rows from the top, the leftmost dot in bit 4.
using Glyph = std::array<std::uint8_t, kRows>;

const std::map<char, Glyph>& glyphs() {
  static const std::map<char, Glyph> table = {
      {'0', {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110}},
      {'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
      {'2', {0b01110, 0b10001, 0b00001, 0b00010, 0b00100, 0b01000, 0b11111}},
      {'3', {0b11111, 0b00010, 0b00100, 0b00010, 0b00001, 0b10001, 0b01110}},
      {'4', {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010}},
      {'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
      {'6', {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110}},
      {'7', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000}},
      {'8', {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110}},
      {'9', {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100}},
      {'-', {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000}},
      {'e', {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110}},
      {'i', {0b00100, 0b00000, 0b01100, 0b00100, 0b00100, 0b00100, 0b01110}},
      {'n', {0b00000, 0b00000, 0b10110, 0b11001, 0b10001, 0b10001, 0b10001}},
      {'f', {0b00110, 0b01001, 0b01000, 0b11100, 0b01000, 0b01000, 0b01000}},
  };
  return table;
}

}  // namespace

int textWidth(const std::string& text, int dot) {
  return static_cast<int>(text.size()) * kAdvance * dot;
}

int textHeight(int dot) { return kRows * dot; }

void drawText(Bitmap& bitmap, int x, int y, const std::string& text, int dot, Rgb8 colour) {
  for (const char c : text) {
    const auto glyph = glyphs().find(c);
    for (int row = 0; glyph != glyphs().end() && row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column)
        if ((glyph->second[static_cast<std::size_t>(row)] >> (kColumns - 1 - column) & 1) != 0)
          bitmap.fill(x + column * dot, y + row * dot, dot, dot, colour);
    x += kAdvance * dot;
  }
}

}  // namespace laver
