// FLIP against the values of its authors' program.
#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "support/expect_error.h"
#include "unit/images.h"

namespace laver::test {
namespace {

constexpr int kWidth = 24, kHeight = 18;

/// A pattern of linear values up to `scale`.
Image pattern(float scale) {
  Image image = rgbImage(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y, static_cast<std::size_t>(c)) =
            scale * static_cast<float>((7 * x + 13 * y + 5 * c * x) % 32) / 31.0F;
  return image;
}

/// The same with a grey box and one greener pixel.
Image changed(float scale) {
  Image image = pattern(scale);
  for (int y = 4; y < 9; ++y)
    for (int x = 5; x < 11; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = 0.5F * scale;
  image.at(15, 12, 1) = scale;
  return image;
}

double at(const std::vector<double>& values, int x, int y) {
  return values[static_cast<std::size_t>(y * kWidth + x)];
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Mean, maximum, and the values in the box, at the greener pixel and in two corners, by
/// flip-evaluator 1.7, which computes in single precision: 1e-4.
void expectValues(const std::vector<double>& values, const std::array<double, 6>& wanted) {
  const std::array<double, 6> found{
      meanOf(values),   *std::max_element(values.begin(), values.end()),
      at(values, 7, 6), at(values, 15, 12),
      at(values, 0, 0), at(values, 23, 17)};
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-4) << i;
}

TEST(Flip, HasTheValuesOfItsAuthorsProgram) {
  expectValues(ldrFlip(changed(1.0F), pattern(1.0F)),
               {0.0457552, 0.345775, 0.271191, 0.266978, 0.00808311, 0.00104352});
  expectValues(hdrFlip(changed(8.0F), pattern(8.0F)),
               {0.0532963, 0.460042, 0.424934, 0.111476, 0.00558847, 0.000415568});
}

TEST(Flip, IsZeroForEqualPicturesAndOneWhereOneIsNotFinite) {
  const Image image = pattern(8.0F);
  for (const double value : hdrFlip(image, image)) EXPECT_EQ(value, 0.0);
  Image broken = image;
  broken.at(3, 2, 1) = kNan;
  for (const auto& values : {hdrFlip(broken, image), ldrFlip(image, broken)}) {
    EXPECT_EQ(at(values, 3, 2), 1.0);
    for (const double value : values) EXPECT_TRUE(value >= 0.0 && value <= 1.0) << value;
  }
}

// A reference without light has no exposure of its own.
TEST(Flip, IsFiniteForBlackReferences) {
  for (const double value : hdrFlip(pattern(1.0F), rgbImage(kWidth, kHeight)))
    EXPECT_TRUE(value >= 0.0 && value <= 1.0) << value;
}

TEST(Flip, NeedsTwoPicturesOfOneSizeWithColours) {
  expectError(ExitCode::Usage, "differ in size", [] { ldrFlip(rgbImage(2, 2), rgbImage(2, 3)); });
  expectError(ExitCode::Usage, "R, G and B",
              [] { hdrFlip(blackImage(2, 2, {"Z"}), blackImage(2, 2, {"Z"})); });
}

}  // namespace
}  // namespace laver::test
