#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "image/io.h"
#include "image/srgb.h"
#include "unit/image_test_folder.h"

namespace laver {
namespace {

using image_test::contents;
using image_test::expectError;
using image_test::Folder;

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

TEST(Png, HoldsTheBytesRowByRowFromTheTop) {
  const Folder folder;
  Image image;
  image.width = 3;
  image.height = 2;
  image.channels = {"B", "Z", "R", "G"};  // found by name
  image.pixels.assign(24, 0.0f);
  image.at(2, 0, 2) = 1.0f;
  image.at(0, 1, 3) = 0.5f;
  image.at(1, 1, 0) = 0.18f;
  image.at(1, 1, 1) = 1.0f;
  writePng(folder.file("a.png"), image);

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, folder.file("a.png").c_str()), 0);
  EXPECT_EQ(png.width, 3u);
  EXPECT_EQ(png.height, 2u);
  EXPECT_EQ(png.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr), 0);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 255, 0, 0,  //
                                              0, 188, 0, 0, 0, 118, 0, 0, 0}));
}

TEST(Png, SaysThatItIsSrgbWithEightBits) {
  const Folder folder;
  writePng(folder.file("a.png"), rgbImage(2, 2));
  const std::string bytes = contents(folder.file("a.png"));
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  ASSERT_GT(bytes.size(), 26u);
  EXPECT_EQ(bytes[24], 8);  // bit depth in IHDR
  EXPECT_EQ(bytes[25], 2);  // truecolour
}

TEST(Png, RefusesWhatIsNoRgbPicture) {
  const Folder folder;
  Image image = rgbImage(2, 2);
  image.channels[1] = "Y";
  expectError(ExitCode::Output, "no channel G", [&] { writePng(folder.file("a.png"), image); });
  expectError(ExitCode::Output, "2 x 0", [&] { writePng(folder.file("a.png"), rgbImage(2, 0)); });
  expectError(ExitCode::Output, "cannot write",
              [&] { writePng(folder.file("a.png"), rgbImage(1000001, 1)); });  // libpng's limit
  EXPECT_EQ(folder.size(), 0u);
}

}  // namespace
}  // namespace laver
