#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "image/io.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

std::vector<std::uint32_t> bits(const std::vector<float>& values) {
  std::vector<std::uint32_t> result;
  result.reserve(values.size());
  for (const float value : values) result.push_back(std::bit_cast<std::uint32_t>(value));
  return result;
}

/// 5 x 4 pixels that hold every kind of float.
Image oddFloats() {
  using Limits = std::numeric_limits<float>;
  const std::vector<float> odd = {0.0f,
                                  -0.0f,
                                  1.0f,
                                  -1.5f,
                                  Limits::max(),
                                  Limits::lowest(),
                                  Limits::min(),
                                  Limits::denorm_min(),
                                  -1e-42f,
                                  Limits::infinity(),
                                  -Limits::infinity(),
                                  Limits::quiet_NaN(),
                                  std::bit_cast<float>(0xffc12345u),
                                  std::bit_cast<float>(0x7f812345u)};
  Image image = rgbImage(5, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = odd[i % odd.size()];
  return image;
}

TEST(Exr, KeepsEveryBitOfEveryKindOfFloat) {
  const TemporaryFolder folder;
  const Image image = oddFloats();
  writeExr(folder.path("a.exr"), image);
  const Image back = readExr(folder.path("a.exr"));
  EXPECT_EQ(back.width, 5);
  EXPECT_EQ(back.height, 4);
  EXPECT_EQ(back.channels, image.channels);
  EXPECT_EQ(bits(back.pixels), bits(image.pixels));
}

TEST(Exr, KeepsEveryBitAcrossChunksAndThreads) {
  // Smooth rows that deflate, and noise that does not and is stored; the last chunk has fewer rows.
  const TemporaryFolder folder;
  Image image = rgbImage(37, 1500);
  std::uint32_t noise = 1;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    noise = noise * 1664525 + 1013904223;
    const std::size_t row = i / 37 / 3, level = i / 300;
    image.pixels[i] =
        row / 64 % 2 == 0 ? static_cast<float>(level) : std::bit_cast<float>(noise ^ noise >> 13);
  }
  for (const unsigned threads : {1U, 3U}) {
    writeExr(folder.path("a.exr"), image, {}, threads);
    EXPECT_EQ(bits(readExr(folder.path("a.exr")).pixels), bits(image.pixels)) << threads;
  }
}

TEST(Exr, PutsTheFirstRowOfPixelsAtTheTop) {
  const TemporaryFolder folder;
  Image image = rgbImage(3, 2);
  image.at(2, 0, 1) = 7.0f;
  writeExr(folder.path("a.exr"), image);

  std::vector<float> green(6);
  Imf::InputFile file(folder.path("a.exr").c_str());
  Imf::FrameBuffer frame;
  frame.insert("G", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(green.data()), sizeof(float),
                               3 * sizeof(float)));
  file.setFrameBuffer(frame);
  file.readPixels(0, 1);
  EXPECT_EQ(green, (std::vector<float>{0, 0, 7, 0, 0, 0}));
}

TEST(Exr, WritesZippedFloatChannels) {
  const TemporaryFolder folder;
  writeExr(folder.path("a.exr"), rgbImage(256, 256));
  const Imf::InputFile file(folder.path("a.exr").c_str());
  EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
  for (const char* name : {"R", "G", "B"}) {
    ASSERT_NE(file.header().channels().findChannel(name), nullptr);
    EXPECT_EQ(file.header().channels().findChannel(name)->type, Imf::FLOAT);
  }
  EXPECT_LT(std::filesystem::file_size(folder.path("a.exr")), 10000u);
}

TEST(Exr, WritesMetadataAsTypedAttributes) {
  const TemporaryFolder folder;
  // Column vectors: column 3 is the translation.
  glm::dmat4 matrix(1.0);
  matrix[3] = glm::dvec4(10.0, 20.0, 30.0, 1.0);
  matrix[1][0] = 5.0;  // row 0, column 1: x' = x + 5 y
  writeExr(folder.path("a.exr"), rgbImage(2, 2),
           {{"comments", std::string("two\nlines")},
            {"renderTimeSeconds", 0.75},
            {"samplesPerPixel", 16},
            {"worldToCamera", matrix}});

  const Imf::InputFile file(folder.path("a.exr").c_str());
  const Imf::Header& header = file.header();
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("comments").value(), "two\nlines");
  EXPECT_EQ(header.typedAttribute<Imf::FloatAttribute>("renderTimeSeconds").value(), 0.75f);
  EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("samplesPerPixel").value(), 16);
  // Row vectors: v * M moves the same point to the same place.
  const Imath::M44f& m = header.typedAttribute<Imf::M44fAttribute>("worldToCamera").value();
  EXPECT_EQ(Imath::V3f(1, 2, 3) * m, Imath::V3f(1 + 10 + 10, 22, 33));
}

TEST(Exr, ReadsHalfAndUintInAnyDataWindow) {
  const TemporaryFolder folder;
  const Imath::Box2i window({-3, 5}, {-2, 7});  // 2 x 3 pixels, not at the display's corner
  Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), window);
  header.channels().insert("Z", Imf::Channel(Imf::HALF));
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  const std::vector<half> z = {0.5f, -1.0f, 2.0f, 3.0f, 4.0f, 65504.0f};
  const std::vector<unsigned> id = {1, 2, 3, 4, 5, 16777216};
  Imf::FrameBuffer frame;
  frame.insert("Z", Imf::Slice::Make(Imf::HALF, z.data(), window));
  frame.insert("id", Imf::Slice::Make(Imf::UINT, id.data(), window));
  {
    Imf::OutputFile file(folder.path("a.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(3);
  }
  const Image image = readExr(folder.path("a.exr"));
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 3);
  EXPECT_EQ(image.channels, (std::vector<std::string>{"Z", "id"}));
  EXPECT_EQ(image.at(0, 0, 0), 0.5f);
  EXPECT_EQ(image.at(1, 0, 0), -1.0f);
  EXPECT_EQ(image.at(1, 2, 0), 65504.0f);
  EXPECT_EQ(image.at(0, 1, 1), 3.0f);
  EXPECT_EQ(image.at(1, 2, 1), 16777216.0f);
}

TEST(Exr, PartsOfAFilmKeepTheirPlace) {
  const TemporaryFolder folder;
  Image part = oddFloats();
  part.window = {10, 5, 64, 48};
  writeExr(folder.path("a.exr"), part);
  const Imf::InputFile file(folder.path("a.exr").c_str());
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({10, 5}, {14, 8}));
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {63, 47}));
  const Image back = readExr(folder.path("a.exr"));
  EXPECT_EQ(back.window, part.window);
  EXPECT_EQ(bits(back.pixels), bits(part.pixels));
  const Image film = onFilm(back);
  EXPECT_EQ(film.width, 64);
  EXPECT_EQ(film.at(10, 5, 2), part.at(0, 0, 2));
  EXPECT_EQ(film.at(9, 5, 2), 0.0F);
}

TEST(Exr, LuminanceAndChromaAreColours) {
  const TemporaryFolder folder;
  const std::string name = folder.path("yc.exr");
  {
    Imf::RgbaOutputFile file(name.c_str(), 8, 8, Imf::WRITE_YC);
    const std::vector<Imf::Rgba> orange(64, Imf::Rgba(1.0F, 0.5F, 0.25F));
    file.setYCRounding(10, 10);  // all bits of half floats
    file.setFrameBuffer(orange.data(), 1, 8);
    file.writePixels(8);
  }
  const Image image = readExr(name);
  ASSERT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B"}));
  for (int i = 0; i < 3; ++i)  // half floats, twice
    EXPECT_NEAR(image.at(4, 4, static_cast<std::size_t>(i)), std::exp2f(-static_cast<float>(i)),
                2e-3F);
}

TEST(Exr, OfSeveralPartsTheFirstIsRead) {
  const TemporaryFolder folder;
  const std::string name = folder.path("parts.exr");
  {
    std::vector<Imf::Header> headers;
    for (const char* part : {"first", "second"}) {
      headers.emplace_back(2, 1);
      headers.back().setName(part);
      headers.back().setType(Imf::SCANLINEIMAGE);
      headers.back().channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(name.c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
      float values[2] = {1.0F + static_cast<float>(i), 7.0F};
      Imf::FrameBuffer frame;
      frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values), 4, 8));
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(frame);
      part.writePixels(1);
    }
  }
  EXPECT_EQ(readExr(name).pixels, (std::vector<float>{1.0F, 7.0F}));
}

TEST(Images, OneLayersColoursLoseTheirPrefix) {
  const auto names = [](std::vector<std::string> channels) {
    return withoutPrefix(blackImage(1, 1, std::move(channels))).channels;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names({"a.R", "a.G", "a.B", "a.A", "b.Z"}), (Names{"R", "G", "B", "A", "b.Z"}));
  for (const Names& kept : {Names{"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"},
                            Names{"Z", "a.R", "a.G", "a.B"}, Names{"a.R", "a.G"}})
    EXPECT_EQ(names(kept), kept);
}

TEST(Images, PartsOfOneFilmAreCutToWhatBothHave) {
  Image whole = rgbImage(6, 4), part = rgbImage(3, 2);
  whole.window = {0, 0, 6, 4};
  part.window = {2, 1, 6, 4};
  whole.at(2, 1, 0) = 5.0F;
  whole.at(4, 2, 2) = 6.0F;
  EXPECT_TRUE(cutToShared(whole, part));
  EXPECT_EQ(whole.window, part.window);
  EXPECT_EQ(whole.width, 3);
  EXPECT_EQ(whole.at(0, 0, 0), 5.0F);
  EXPECT_EQ(whole.at(2, 1, 2), 6.0F);
  EXPECT_FALSE(cutToShared(whole, part));
  Image elsewhere = rgbImage(1, 1);
  elsewhere.window = {5, 3, 6, 4};
  expectError(ExitCode::Usage, "do not overlap", [&] { cutToShared(elsewhere, part); });
  Image other = rgbImage(3, 2);
  EXPECT_FALSE(cutToShared(other, part));
}

TEST(Exr, KeepsLayersAndOrdersColoursFirst) {
  const TemporaryFolder folder;
  Image image;
  image.width = image.height = 1;
  image.channels = {"N.Z", "Z", "B", "N.X", "albedo.G", "R", "A", "albedo.R", "G"};
  image.pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  writeExr(folder.path("a.exr"), image);
  const Image back = readExr(folder.path("a.exr"));
  EXPECT_EQ(back.channels, (std::vector<std::string>{"R", "G", "B", "A", "Z", "N.X", "N.Z",
                                                     "albedo.R", "albedo.G"}));
  EXPECT_EQ(back.pixels, (std::vector<float>{6, 9, 3, 7, 2, 4, 1, 8, 5}));
}

TEST(Exr, ExplainsInOneLineWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  const std::string missing = folder.path("missing.exr");
  expectError(ExitCode::Usage, "missing.exr\": No such file", [&] { readExr(missing); });
  expectError(ExitCode::Usage, "cannot read", [&] { readExr(folder.path("")); });

  std::ofstream(folder.path("text.exr")) << "this is no picture";
  expectError(ExitCode::Usage, "text.exr", [&] { readExr(folder.path("text.exr")); });

  Image noise = rgbImage(64, 64);
  for (std::size_t i = 0; i < noise.pixels.size(); ++i) {
    noise.pixels[i] = static_cast<float>((i * 2654435761u) % 100003u);
  }
  writeExr(folder.path("cut.exr"), noise);
  std::filesystem::resize_file(folder.path("cut.exr"), 20000);
  expectError(ExitCode::Usage, "cut.exr", [&] { readExr(folder.path("cut.exr")); });
}

TEST(Exr, RefusesInvalidImagesAndAttributes) {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.exr");
  Image image = rgbImage(2, 2);
  image.pixels.pop_back();
  expectError(ExitCode::Output, "11 numbers, not 12", [&] { writeExr(file, image); });
  expectError(ExitCode::Output, "0 x 2", [&] { writeExr(file, rgbImage(0, 2)); });
  image = rgbImage(2, 2);
  image.channels[2] = "R";
  expectError(ExitCode::Output, "twice", [&] { writeExr(file, image); });
  expectError(ExitCode::Output, "channels", [&] {
    writeExr(file, rgbImage(2, 2), {{"channels", 3}});
  });
  EXPECT_EQ(folder.names().size(), 0u);
}

}  // namespace
}  // namespace laver::test
