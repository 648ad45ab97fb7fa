#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/compare.h"
#include "image/false_colour.h"
#include "support/expect_error.h"
#include "unit/images.h"

namespace laver::test {
namespace {

constexpr Rgb8 kBlack = {0, 0, 0}, kMagenta = {255, 0, 255};

/// Rec. 709 luma, by which a colour map is readable in grey.
double luma(Rgb8 c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

TEST(Difference, IsSignedAndMatchesChannelsByName) {
  const Image a = row({"G", "Z"}, {1, 2, 3, 4});
  const Image b = row({"Z", "G"}, {2.5, 0.75, 4, 10});
  const Image d = difference(a, b);
  EXPECT_EQ(d.channels, a.channels);
  EXPECT_EQ(d.pixels, (std::vector<float>{0.25F, -0.5F, -7, 0}));
  EXPECT_EQ(largestDistances(a, b), (std::vector<double>{0.5, 7}));
}

TEST(Difference, OfNonFiniteValues) {
  const Image a = row({"Y"}, {kNan, kInfinity, kInfinity, 1, kNan});
  const Image b = row({"Y"}, {kNan, kInfinity, -kInfinity, kInfinity, 1});
  const Image d = difference(a, b);
  EXPECT_EQ(d.pixels[0], 0.0F);
  EXPECT_EQ(d.pixels[1], 0.0F);
  EXPECT_EQ(d.pixels[2], kInfinity);
  EXPECT_EQ(d.pixels[3], -kInfinity);
  EXPECT_TRUE(std::isnan(d.pixels[4]));
  EXPECT_EQ(largestDistances(a, b), (std::vector<double>{0, 0, kEndless, kEndless, kEndless}));
}

TEST(Difference, RefusesPicturesThatDoNotMatch) {
  const Image a = rgbImage(4, 2);
  expectError(ExitCode::Usage, "4 x 2 and 2 x 4", [&] { difference(a, rgbImage(2, 4)); });
  Image b = a;
  b.channels[0] = "X";
  expectError(ExitCode::Usage, "differ in channels", [&] { largestDistances(a, b); });
}

TEST(FalseColour, DistinguishesEqualAlmostEqualAndNotFinite) {
  const LogScale scale;
  EXPECT_EQ(falseColour(0.0, scale), kBlack);
  EXPECT_EQ(falseColour(-0.0, scale), kBlack);
  EXPECT_EQ(falseColour(kEndless, scale), kMagenta);
  EXPECT_EQ(falseColour(1e-300, scale), (Rgb8{68, 1, 84}));  // viridis begins here
  EXPECT_EQ(falseColour(1e300, scale), (Rgb8{253, 231, 37}));
}

TEST(FalseColour, GetsBrighterWithEveryQuarterOfADecade) {
  const LogScale scale;
  double last = -1.0;
  for (double e = -8.0; e <= 0.0; e += 0.25) {
    const double now = luma(falseColour(std::pow(10.0, e), scale));
    EXPECT_GT(now, last + 1.0) << e;
    last = now;
  }
}

TEST(FalseColour, ScaleIsFixedUnlessADistanceExceedsIt) {
  const auto high = [](std::vector<double> distances) { return scaleFor(distances).high; };
  EXPECT_EQ(high({0, 1e-7}), 0);
  EXPECT_EQ(high({kEndless, 1.0}), 0);
  EXPECT_EQ(high({1.001}), 1);
  EXPECT_EQ(high({2500, 10}), 4);
  EXPECT_EQ(scaleFor(std::vector<double>{2500}).low, -8);
}

TEST(DrawDistances, ShowsThePictureAndTheScale) {
  for (const auto& [width, height] : {std::pair(3, 2), std::pair(40, 600), std::pair(1000, 1)}) {
    std::vector<double> distances(static_cast<std::size_t>(width * height), 1e-6);
    distances[0] = 0.0;
    distances[1 % distances.size()] = kEndless;
    distances.back() = 1e-2;
    Bitmap bitmap = drawDistances(distances, width, height);
    const LogScale scale;
    EXPECT_EQ(bitmap.at(0, 0), kBlack);
    EXPECT_EQ(bitmap.at(1, 0), kMagenta);
    EXPECT_EQ(bitmap.at(width - 1, height - 1), falseColour(1e-2, scale));
    EXPECT_EQ(bitmap.at(2, 0), falseColour(1e-6, scale));

    // Along the middle of the scale, from the top: the colour of every decade from 1 to 10^-8, then
    // "0" and "inf".
    std::vector<Rgb8> expected;
    for (int e = scale.high; e >= scale.low; --e)
      expected.push_back(falseColour(std::pow(10, e), scale));
    expected.push_back(kBlack);
    expected.push_back(kMagenta);
    std::size_t found = 0;
    for (int y = 0; y < bitmap.height && found < expected.size(); ++y) {
      const Rgb8 colour = bitmap.at(width + 10, y);
      double off = 0;
      for (const std::size_t c : {0U, 1U, 2U})
        off = std::max(off, std::abs(static_cast<double>(colour[c]) - expected[found][c]));
      if (off <= 4) ++found;  // rows need not fall on decades
    }
    EXPECT_EQ(found, expected.size()) << width << " x " << height;
  }
}

TEST(DrawText, DrawsDotsInsideItsBox) {
  const Rgb8 paper = {255, 255, 255}, ink = {1, 2, 3};
  const std::string text = "1e-8";
  Bitmap bitmap(textWidth(text, 3) + 2, textHeight(3) + 2, paper);
  drawText(bitmap, 1, 1, text, 3, ink);
  // The dash of "-" is 5 dots in the fourth row of the third glyph.
  for (int x = 0; x < 15; ++x) EXPECT_EQ(bitmap.at(1 + 2 * 18 + x, 1 + 3 * 3), ink) << x;
  EXPECT_EQ(bitmap.at(1 + 2 * 18, 1), paper);
  // No two characters look the same.
  std::vector<std::vector<Rgb8>> pictures;
  for (const char c : std::string("0123456789e-inf ")) {
    Bitmap one(textWidth("0", 1), textHeight(1), paper);
    drawText(one, 0, 0, std::string(1, c), 1, ink);
    for (const auto& other : pictures) EXPECT_NE(one.pixels, other) << c;
    pictures.push_back(one.pixels);
  }
}

}  // namespace
}  // namespace laver::test
