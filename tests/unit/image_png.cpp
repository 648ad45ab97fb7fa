#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "image/io.h"
#include "image/srgb.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

void writePicture(const std::string& file, const Image& image) {
  replaceFile(file, encodePng(image, file));
}

TEST(Srgb, FollowsTheCurveAndRoundsToNearest) {
  EXPECT_EQ(srgb8(0.0f), 0);
  EXPECT_EQ(srgb8(0.0001f), 0);      // 0.3295
  EXPECT_EQ(srgb8(0.0001517f), 0);   // 0.49979
  EXPECT_EQ(srgb8(0.0001518f), 1);   // 0.50012
  EXPECT_EQ(srgb8(0.0031308f), 10);  // 10.3146, the end of the straight part
  EXPECT_EQ(srgb8(0.01f), 25);       // 25.4625
  EXPECT_EQ(srgb8(0.18f), 118);      // 117.6, truncated it would be 117
  EXPECT_EQ(srgb8(0.21404f), 127);   // 127.4997
  EXPECT_EQ(srgb8(0.21405f), 128);   // 127.5024
  EXPECT_EQ(srgb8(0.5f), 188);       // 187.516
  EXPECT_EQ(srgb8(0.99f), 254);      // 253.876
  EXPECT_EQ(srgb8(1.0f), 255);
}

TEST(Srgb, ClampsAndTurnsNanBlack) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(srgb8(-0.5f), 0);
  EXPECT_EQ(srgb8(-infinity), 0);
  EXPECT_EQ(srgb8(1.5f), 255);
  EXPECT_EQ(srgb8(3e38f), 255);
  EXPECT_EQ(srgb8(infinity), 255);
  EXPECT_EQ(srgb8(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Srgb, InvertsTheDecodingOfEveryByte) {
  for (int byte = 0; byte < 256; ++byte) {
    const double y = byte / 255.0;
    const double x = y <= 0.04045 ? y / 12.92 : std::pow((y + 0.055) / 1.055, 2.4);
    EXPECT_EQ(srgb8(static_cast<float>(x)), byte);
  }
}

TEST(Srgb, TheTableEqualsTheFormula) {
  const SrgbTable& table = SrgbTable::shared();
  // Every 509th float from below 2^-13 to above 1 (a prime, so all low bits occur), and all floats
  // around each step of the curve.
  std::uint32_t steps = 0;
  const auto end = std::bit_cast<std::uint32_t>(1.25f);
  for (auto bits = std::bit_cast<std::uint32_t>(1e-4f); bits < end; bits += 509) {
    const auto x = std::bit_cast<float>(bits);
    ASSERT_EQ(table(x), srgb8(x)) << x;
    if (srgb8(x) == srgb8(std::bit_cast<float>(bits + 509))) continue;
    ++steps;
    for (std::uint32_t near = bits; near < bits + 509; ++near)
      ASSERT_EQ(table(std::bit_cast<float>(near)), srgb8(std::bit_cast<float>(near))) << near;
  }
  EXPECT_EQ(steps, 255U);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float x : {-infinity, -1.0f, -0.0f, 0.0f, 1e-40f, 3e38f, infinity,
                        std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(table(x), srgb8(x)) << x;
}

TEST(Png, HoldsTheBytesRowByRowFromTheTop) {
  const TemporaryFolder folder;
  Image image;
  image.width = 3;
  image.height = 2;
  image.channels = {"B", "Z", "R", "G"};  // found by name
  image.pixels.assign(24, 0.0f);
  image.at(2, 0, 2) = 1.0f;
  image.at(0, 1, 3) = 0.5f;
  image.at(1, 1, 0) = 0.18f;
  image.at(1, 1, 1) = 1.0f;
  writePicture(folder.path("a.png"), image);

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, folder.path("a.png").c_str()), 0);
  EXPECT_EQ(png.width, 3u);
  EXPECT_EQ(png.height, 2u);
  EXPECT_EQ(png.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr), 0);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 255, 0, 0,  //
                                              0, 188, 0, 0, 0, 118, 0, 0, 0}));
}

TEST(Png, IsMarkedAsSrgbWithEightBits) {
  const TemporaryFolder folder;
  writePicture(folder.path("a.png"), rgbImage(2, 2));
  const std::string bytes = contents(folder.path("a.png"));
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  ASSERT_GT(bytes.size(), 26u);
  EXPECT_EQ(bytes[24], 8);  // bit depth in IHDR
  EXPECT_EQ(bytes[25], 2);  // truecolour
}

TEST(Png, RefusesImagesWithoutRgb) {
  Image image = rgbImage(2, 2);
  image.channels[1] = "Y";
  expectError(ExitCode::Output, "no channel G", [&] { encodePng(image, "a.png"); });
  expectError(ExitCode::Output, "2 x 0", [&] { encodePng(rgbImage(2, 0), "a.png"); });
  expectError(ExitCode::Output, "cannot write",
              [&] { encodePng(rgbImage(1000001, 1), "a.png"); });  // libpng's limit
}

TEST(Png, KeepsEveryByteOfEveryKindOfRow) {
  // Noise, runs, ramps and rows like the one above: all of libpng's filters are chosen.
  const TemporaryFolder folder;
  Bitmap bitmap(301, 200, {});
  std::uint32_t noise = 1;
  for (std::size_t i = 0; i < bitmap.pixels.size(); ++i)
    for (std::uint8_t& c : bitmap.pixels[i]) {
      noise = noise * 1664525 + 1013904223;
      const std::size_t row = i / 301, kind = row / 40;
      c = static_cast<std::uint8_t>(kind == 0   ? noise >> 24
                                    : kind == 1 ? 7
                                    : kind == 2 ? i
                                    : kind == 3 ? i % 301 * 3 + row
                                                : (i % 301) * (i % 301));
    }
  writePng(folder.path("a.png"), bitmap);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, folder.path("a.png").c_str()), 0);
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr), 0);
  ASSERT_EQ(bytes.size(), bitmap.pixels.size() * 3);
  EXPECT_EQ(std::memcmp(bytes.data(), bitmap.pixels.data(), bytes.size()), 0);
}

}  // namespace
}  // namespace laver::test
