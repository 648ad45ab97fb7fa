#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/error.h"
#include "image/atomic_file.h"
#include "image/image_defect.h"
#include "image/io.h"
#include "image/srgb.h"

namespace laver {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& reason) {
  throw Error(ExitCode::Output, fmt::format("cannot write \"{}\": {}", file, reason));
}

std::size_t channelIndex(const std::string& file, const Image& image, const char* name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  if (found == image.channels.end()) refuse(file, fmt::format("it has no channel {}", name));
  return static_cast<std::size_t>(found - image.channels.begin());
}

/// R, G, B of every pixel.
Bitmap srgbBitmap(const std::string& file, const Image& image) {
  const std::array<std::size_t, 3> rgb = {channelIndex(file, image, "R"),
                                          channelIndex(file, image, "G"),
                                          channelIndex(file, image, "B")};
  Bitmap bitmap(image.width, image.height, {});
  const float* pixel = image.pixels.data();
  for (Rgb8& colour : bitmap.pixels) {
    for (std::size_t c = 0; c < 3; ++c) colour[c] = srgb8(pixel[rgb[c]]);
    pixel += image.channels.size();
  }
  return bitmap;
}

}  // namespace

void writePng(const std::string& file, const Image& image) {
  if (const std::string defect = imageDefect(image); !defect.empty()) refuse(file, defect);
  writePng(file, srgbBitmap(file, image));
}

void writePng(const std::string& file, const Bitmap& bitmap) {
  static_assert(sizeof(Rgb8) == 3);
  // libpng's simplified interface: no longjmp across our frames, and it marks 8-bit data as sRGB.
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(bitmap.width);
  png.height = static_cast<png_uint_32>(bitmap.height);
  png.format = PNG_FORMAT_RGB;
  std::vector<std::byte> encoded(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t size = encoded.size();
  if (png_image_write_to_memory(&png, encoded.data(), &size, 0, bitmap.pixels.data(), 0, nullptr) ==
      0) {
    refuse(file, png.message);
  }
  encoded.resize(size);
  replaceFile(file, encoded);
}

}  // namespace laver
