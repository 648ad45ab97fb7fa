#include "image/exr_zip.h"

#include <libdeflate.h>

#include <bit>
#include <cstring>
#include <memory>
#include <new>

namespace laver {
namespace {

static_assert(std::endian::native == std::endian::little, "EXR files hold little-endian floats");

/// Measured on noisy pictures: 2.4 times as fast as zlib's usual level 6, files 0.3 % larger; level
/// 1 saves a fifth more and costs 1 %.
constexpr int kLevel = 4;

std::vector<std::byte> plainRows(const Image& image, std::span<const std::size_t> channels, int y0,
                                 int y1) {
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t stride = image.channels.size();
  std::vector<std::byte> rows(width * channels.size() * static_cast<std::size_t>(y1 - y0) *
                              sizeof(float));
  std::byte* to = rows.data();
  for (int y = y0; y < y1; ++y)
    for (const std::size_t channel : channels) {
      const float* from = &image.pixels[static_cast<std::size_t>(y) * width * stride + channel];
      for (std::size_t x = 0; x < width; ++x, to += sizeof(float))
        std::memcpy(to, from + x * stride, sizeof(float));
    }
  return rows;
}

/// Even bytes before odd ones, then each as its difference from the one before, plus 128.
std::vector<unsigned char> predicted(const std::vector<std::byte>& plain) {
  const std::size_t size = plain.size(), half = (size + 1) / 2;
  std::vector<unsigned char> sorted(size), result(size);
  for (std::size_t i = 0; i < half; ++i) sorted[i] = static_cast<unsigned char>(plain[2 * i]);
  for (std::size_t i = half; i < size; ++i)
    sorted[i] = static_cast<unsigned char>(plain[2 * (i - half) + 1]);
  result[0] = sorted[0];
  for (std::size_t i = 1; i < size; ++i)
    result[i] = static_cast<unsigned char>(sorted[i] - sorted[i - 1] + 128);
  return result;
}

}  // namespace

std::vector<std::byte> exrZipChunk(const Image& image, std::span<const std::size_t> channels,
                                   int y0, int y1) {
  using Compressor = std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)>;
  thread_local const Compressor compressor(libdeflate_alloc_compressor(kLevel),
                                           libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::vector<std::byte> plain = plainRows(image, channels, y0, y1);
  const std::vector<unsigned char> bytes = predicted(plain);
  std::vector<std::byte> packed(plain.size());
  const std::size_t size = libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                                    packed.data(), packed.size() - 1);
  if (size == 0) return plain;
  packed.resize(size);
  return packed;
}

}  // namespace laver
