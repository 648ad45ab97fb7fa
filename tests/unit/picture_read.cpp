// Images for textures: every supported kind of PNG, JPEG and EXR, and refused files.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/io.h"
#include "image/picture.h"
#include "support/expect_error.h"
#include "support/picture_files.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

using Rows = std::vector<std::vector<unsigned char>>;

Picture read(const std::string& bytes, bool raw = false) {
  const TemporaryFolder folder;
  const std::string file = folder.path("picture");
  std::ofstream(file, std::ios::binary) << bytes;
  return readPicture(file, raw);
}

std::vector<Rgb8> bytesOf(const Picture& picture) { return std::get<Bitmap>(picture).pixels; }

TEST(PictureRead, PngOfEveryColourType) {
  const std::vector<Rgb8> grey = {{0, 0, 0}, {255, 255, 255}};
  EXPECT_EQ(bytesOf(read(png(2, 1, 8, PNG_COLOR_TYPE_RGB, {{1, 2, 3, 250, 251, 252}}))),
            (std::vector<Rgb8>{{1, 2, 3}, {250, 251, 252}}));
  EXPECT_EQ(bytesOf(read(png(2, 1, 8, PNG_COLOR_TYPE_GRAY, {{0, 255}}))), grey);
  EXPECT_EQ(bytesOf(read(png(2, 1, 1, PNG_COLOR_TYPE_GRAY, {{0x40}}))), grey);
  EXPECT_EQ(bytesOf(read(png(2, 1, 2, PNG_COLOR_TYPE_PALETTE, {{0x2 << 6 | 0x1 << 4}}))),
            (std::vector<Rgb8>{{20, 40, 60}, {10, 20, 30}}));
}

TEST(PictureRead, AlphaOfAPngChangesNothing) {
  EXPECT_EQ(bytesOf(read(png(2, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, {{9, 8, 7, 0, 6, 5, 4, 128}}))),
            (std::vector<Rgb8>{{9, 8, 7}, {6, 5, 4}}));
  EXPECT_EQ(bytesOf(read(png(1, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {{77, 3}}))),
            (std::vector<Rgb8>{{77, 77, 77}}));
}

TEST(PictureRead, AnInterlacedPngEqualsAPlainOne) {
  Rows rows;
  for (unsigned y = 0; y < 9; ++y) {
    rows.emplace_back();
    for (unsigned x = 0; x < 3 * 11; ++x)
      rows.back().push_back(static_cast<unsigned char>(31 * y + 7 * x));
  }
  const auto bytes = [&](int interlace) {
    return bytesOf(read(png(11, 9, 8, PNG_COLOR_TYPE_RGB, rows, interlace)));
  };
  EXPECT_EQ(bytes(PNG_INTERLACE_ADAM7), bytes(PNG_INTERLACE_NONE));
}

TEST(PictureRead, SixteenBitsAreLinearFloatsByTheCurveOrRaw) {
  const std::string file =
      png(2, 1, 16, PNG_COLOR_TYPE_RGB, {{0x80, 0x00, 0x00, 0x01, 0xff, 0xff, 1, 2, 3, 4, 5, 6}});
  const auto image = std::get<Image>(read(file));
  EXPECT_EQ(image.width, 2);
  EXPECT_FLOAT_EQ(image.at(0, 0, 0),
                  static_cast<float>(std::pow((0x8000 / 65535.0 + 0.055) / 1.055, 2.4)));
  EXPECT_FLOAT_EQ(image.at(0, 0, 1), static_cast<float>(1 / 65535.0 / 12.92));
  EXPECT_EQ(image.at(0, 0, 2), 1.0F);
  const auto raw = std::get<Image>(read(file, true));
  EXPECT_FLOAT_EQ(raw.at(0, 0, 0), static_cast<float>(0x8000 / 65535.0));
  EXPECT_FLOAT_EQ(raw.at(1, 0, 2), static_cast<float>(0x0506 / 65535.0));
}

TEST(PictureRead, JpegInColourAndGrey) {
  // An image of one colour survives the cosine transform to within a step.
  const auto close = [](const Rgb8& a, const Rgb8& b) {
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(a[c] - b[c]) > 2) return false;
    return true;
  };
  const auto colour = bytesOf(read(jpeg(1, 2, 3, JCS_RGB, {200, 100, 50, 200, 100, 50})));
  ASSERT_EQ(colour.size(), 2U);
  EXPECT_TRUE(close(colour[1], {200, 100, 50}));
  const auto grey = bytesOf(read(jpeg(2, 1, 1, JCS_GRAYSCALE, {90, 90})));
  EXPECT_TRUE(close(grey[0], {90, 90, 90}));
  EXPECT_EQ(grey[0][0], grey[0][2]);
}

TEST(PictureRead, InksAreRefused) {
  const std::string file = jpeg(1, 1, 4, JCS_CMYK, {1, 2, 3, 4});
  expectError(ExitCode::Usage, "it holds inks (CMYK)", [&] { read(file); });
}

Image exr(const std::vector<std::string>& channels, const std::vector<float>& pixels) {
  Image image;
  image.width = static_cast<int>(pixels.size() / channels.size());
  image.height = 1;
  image.channels = channels;
  image.pixels = pixels;
  return image;
}

Picture throughExr(const Image& image) {
  const TemporaryFolder folder;
  writeExr(folder.path("a.exr"), image);
  return readPicture(folder.path("a.exr"), false);
}

TEST(PictureRead, ExrByTheNamesOfItsChannels) {
  const auto color = std::get<Image>(
      throughExr(exr({"A", "B", "G", "R", "Z"}, {0.5F, 3, 2, 1, 9, 0.5F, 6, 5, -4, 9})));
  EXPECT_EQ(color.pixels, (std::vector<float>{1, 2, 3, -4, 5, 6}));
  const auto grey = std::get<Image>(throughExr(exr({"Y"}, {7, 8})));
  EXPECT_EQ(grey.pixels, (std::vector<float>{7, 7, 7, 8, 8, 8}));
  expectError(ExitCode::Usage, "neither channels R, G, B nor Y", [] {
    throughExr(exr({"R", "G"}, {1, 2}));
  });
  expectError(ExitCode::Usage, "the pixel in column 1, row 0 is not finite", [] {
    throughExr(exr({"Y"}, {1, std::numeric_limits<float>::infinity()}));
  });
}

TEST(PictureRead, EveryTruncationIsRefusedWithAReason) {
  std::vector<unsigned char> noise;
  for (unsigned i = 0; i < 16 * 16 * 3; ++i)
    noise.push_back(static_cast<unsigned char>(i * i * 37 >> 3));
  Rows rows;
  for (std::ptrdiff_t y = 0; y < 16; ++y)
    rows.emplace_back(noise.begin() + 48 * y, noise.begin() + 48 * (y + 1));
  const TemporaryFolder folder;
  Image image = rgbImage(16, 16);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(noise[i]) / 255.0F;
  writeExr(folder.path("a.exr"), image);
  for (const std::string& whole :
       {png(16, 16, 8, PNG_COLOR_TYPE_RGB, rows), jpeg(16, 16, 3, JCS_RGB, noise),
        contents(folder.path("a.exr"))}) {
    EXPECT_NO_THROW(read(whole));
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 20) {
      expectError(ExitCode::Usage, "cannot read \"", [&] { read(whole.substr(0, length)); });
    }
  }
}

TEST(PictureRead, DamagedBytesAreAReasonOrAPicture) {
  Rows rows(8, std::vector<unsigned char>(24, 100));
  const std::string whole = png(8, 8, 8, PNG_COLOR_TYPE_RGB, rows);
  int refused = 0;
  for (std::size_t i = 4; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    try {
      read(damaged);
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(error.code(), ExitCode::Usage);
    }
  }
  EXPECT_GT(refused, static_cast<int>(whole.size()) / 2);  // by their checksums
}

TEST(PictureRead, AHugeSizeIsRefusedBeforeMemoryIsAllocated) {
  EXPECT_NO_THROW(checkPictureSize(65536, 2048));
  EXPECT_THROW(checkPictureSize(65537, 1), std::runtime_error);
  EXPECT_THROW(checkPictureSize(16384, 8193), std::runtime_error);
  EXPECT_THROW(checkPictureSize(0, 5), std::runtime_error);
}

TEST(PictureRead, OtherFilesAreRefused) {
  const TemporaryFolder folder;
  expectError(ExitCode::Usage, "neither PNG, JPEG nor OpenEXR", [] { read("hello"); });
  expectError(ExitCode::Usage, "neither PNG, JPEG nor OpenEXR", [] { read(""); });
  expectError(ExitCode::Usage, "No such file", [&] { readPicture(folder.path("x.png"), false); });
  expectError(ExitCode::Usage, "it is a folder", [&] { readPicture(folder.path("."), false); });
}

TEST(PictureRead, APointerOfGitLfsIsNamedAsOne) {
  expectError(ExitCode::Usage, "it is a pointer of Git LFS",
              [] { read("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n"); });
}

}  // namespace
}  // namespace laver::test
