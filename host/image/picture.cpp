#include "image/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <system_error>

#include "core/error.h"
#include "core/lfs_pointer.h"
#include "image/io.h"

namespace laver {
namespace {

std::string bytesOf(const std::string& file) {
  if (std::error_code error; std::filesystem::is_directory(file, error))
    throw std::runtime_error("it is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(std::generic_category().message(errno));
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::ptrdiff_t indexOf(const Image& image, const char* channel) {
  const auto& names = image.channels;
  const auto found = std::find(names.begin(), names.end(), channel);
  return found == names.end() ? -1 : found - names.begin();
}

/// R, G, B of an EXR picture, under a prefix or none, or its Y three times.
Image colours(const Image& given) {
  const Image image = withoutPrefix(given);
  std::array<std::ptrdiff_t, 3> from = {indexOf(image, "R"), indexOf(image, "G"),
                                        indexOf(image, "B")};
  if (std::min({from[0], from[1], from[2]}) < 0) from.fill(indexOf(image, "Y"));
  if (from[0] < 0) throw std::runtime_error("it has neither channels R, G, B nor Y");
  Image result = rgbImage(image.width, image.height);
  const float* pixel = image.pixels.data();
  for (std::size_t i = 0; i < result.pixels.size(); i += 3, pixel += image.channels.size())
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = pixel[from[c]];
      if (!std::isfinite(value))
        throw std::runtime_error(fmt::format("the pixel in column {}, row {} is not finite",
                                             i / 3 % static_cast<std::size_t>(image.width),
                                             i / 3 / static_cast<std::size_t>(image.width)));
      result.pixels[i + c] = value;
    }
  return result;
}

}  // namespace

int widthOf(const Picture& picture) {
  return std::visit([](const auto& p) { return p.width; }, picture);
}

int heightOf(const Picture& picture) {
  return std::visit([](const auto& p) { return p.height; }, picture);
}

double linearOfSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

void checkPictureSize(std::size_t width, std::size_t height) {
  constexpr std::size_t kSide = std::size_t{1} << 16, kPixels = std::size_t{1} << 27;
  if (width == 0 || height == 0 || width > kSide || height > kSide || width * height > kPixels)
    throw std::runtime_error(
        fmt::format("it has {} x {} pixels; up to {} a side and {} in all are read", width, height,
                    kSide, kPixels));
}

Picture readPicture(const std::string& file, bool raw) {
  std::string reason;
  try {
    const std::string text = bytesOf(file);
    const auto bytes = std::as_bytes(std::span(text));
    if (text.starts_with("\x89PNG")) return decodePng(bytes, raw);
    if (text.starts_with("\xFF\xD8\xFF")) return decodeJpeg(bytes);
    if (text.starts_with("\x76\x2f\x31\x01")) {
      const Image image = readExr(file);
      checkPictureSize(static_cast<std::size_t>(image.width),
                       static_cast<std::size_t>(image.height));
      return colours(image);
    }
    reason = isLfsPointer(text) ? std::string("it ") + kLfsPointer
                                : "it is neither PNG, JPEG nor OpenEXR";
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    reason = "it is too large for the memory";
  } catch (const std::exception& error) {
    reason = error.what();
  }
  throw Error(ExitCode::Usage, fmt::format("cannot read \"{}\": {}", file, reason));
}

}  // namespace laver
