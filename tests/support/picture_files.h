#pragma once
#include <cstdio>  // jpeglib.h wants FILE
//
#include <jpeglib.h>
#include <png.h>

#include <csetjmp>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace laver::test {

/// A PNG file from rows of samples of `depth` bits each, most significant byte first. The palette
/// of a PNG_COLOR_TYPE_PALETTE has the colours (10 i, 20 i, 30 i).
inline std::string png(int width, int height, int depth, int colorType,
                       const std::vector<std::vector<unsigned char>>& rows,
                       int interlace = PNG_INTERLACE_NONE) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(p))
            ->append(reinterpret_cast<const char*>(data), size);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), depth,
               colorType, interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette;
  for (unsigned i = 0; i < 4; ++i)
    palette.push_back({static_cast<png_byte>(10 * i), static_cast<png_byte>(20 * i),
                       static_cast<png_byte>(30 * i)});
  if (colorType == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), 4);
  std::vector<png_bytep> pointers;
  pointers.reserve(rows.size());
  for (const auto& row : rows) pointers.push_back(const_cast<png_bytep>(row.data()));
  png_write_info(png, info);
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// A JPEG file of the best quality, without subsampling; `channels` values per pixel.
inline std::string jpeg(int width, int height, int channels, J_COLOR_SPACE space,
                        std::vector<unsigned char> samples) {
  jpeg_compress_struct file{};
  jpeg_error_mgr errors{};
  file.err = jpeg_std_error(&errors);
  jpeg_create_compress(&file);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&file, &memory, &size);
  file.image_width = static_cast<JDIMENSION>(width);
  file.image_height = static_cast<JDIMENSION>(height);
  file.input_components = channels;
  file.in_color_space = space;
  jpeg_set_defaults(&file);
  jpeg_set_quality(&file, 100, TRUE);
  for (int c = 0; c < file.num_components; ++c)
    file.comp_info[c].h_samp_factor = file.comp_info[c].v_samp_factor = 1;
  jpeg_start_compress(&file, TRUE);
  for (int y = 0; y < height; ++y) {
    JSAMPROW row = samples.data() + static_cast<std::ptrdiff_t>(y) * width * channels;
    jpeg_write_scanlines(&file, &row, 1);
  }
  jpeg_finish_compress(&file);
  std::string bytes(reinterpret_cast<const char*>(memory), size);
  jpeg_destroy_compress(&file);
  std::free(memory);
  return bytes;
}

}  // namespace laver::test
