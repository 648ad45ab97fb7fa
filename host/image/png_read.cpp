#include <png.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "image/picture.h"

namespace laver {
namespace {

/// libpng leaves by longjmp: no function that may be left so holds an object with a destructor.
class PngReader {
 public:
  explicit PngReader(std::span<const std::byte> bytes) : left_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail,
                                  [](png_structp, png_const_charp) {});
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// Reads up to the pixels and asks for R, G, B of 8 or 16 bits.
  bool readHeader() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_user_limits(png_, 1U << 16, 1U << 16);
    png_set_read_fn(png_, this, take);
    png_read_info(png_, info_);
    png_set_expand(png_);
    png_set_gray_to_rgb(png_);
    png_set_strip_alpha(png_);
    if (std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool readRows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  std::size_t width() const { return png_get_image_width(png_, info_); }
  std::size_t height() const { return png_get_image_height(png_, info_); }
  std::size_t rowBytes() const { return png_get_rowbytes(png_, info_); }
  bool deep() const { return png_get_bit_depth(png_, info_) == 16; }

  [[noreturn]] void refuse() const { throw std::runtime_error(reason_.data()); }

 private:
  static void fail(png_structp png, png_const_charp message) {
    auto& reason = static_cast<PngReader*>(png_get_error_ptr(png))->reason_;
    std::strncpy(reason.data(), message, reason.size() - 1);
    png_longjmp(png, 1);
  }

  static void take(png_structp png, png_bytep to, std::size_t count) {
    auto& left = static_cast<PngReader*>(png_get_io_ptr(png))->left_;
    if (count > left.size()) png_error(png, "it ends too early");
    std::memcpy(to, left.data(), count);
    left = left.subspan(count);
  }

  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::span<const std::byte> left_;
  std::array<char, 200> reason_{};
};

/// Rows of `Pixel`, read to the end of the file.
template <class Pixel>
void readPixels(PngReader& reader, std::vector<Pixel>& pixels) {
  if (reader.rowBytes() != reader.width() * sizeof(Pixel))
    throw std::runtime_error("its pixels are of an unknown kind");
  std::vector<png_bytep> rows(reader.height());
  for (std::size_t y = 0; y < rows.size(); ++y)
    rows[y] = reinterpret_cast<png_bytep>(&pixels[y * reader.width()]);
  if (!reader.readRows(rows.data())) reader.refuse();
}

}  // namespace

Picture decodePng(std::span<const std::byte> bytes, bool raw) {
  PngReader reader(bytes);
  if (!reader.readHeader()) reader.refuse();
  checkPictureSize(reader.width(), reader.height());
  const int width = static_cast<int>(reader.width()), height = static_cast<int>(reader.height());
  if (!reader.deep()) {
    Bitmap bitmap(width, height, {});
    readPixels(reader, bitmap.pixels);
    return bitmap;
  }
  std::vector<std::array<std::uint16_t, 3>> pixels(reader.width() * reader.height());
  readPixels(reader, pixels);
  Image image = rgbImage(width, height);
  float* to = image.pixels.data();
  for (const auto& pixel : pixels)
    for (const std::uint16_t value : pixel) {
      const double x = value / 65535.0;
      *to++ = static_cast<float>(raw ? x : linearOfSrgb(x));
    }
  return image;
}

}  // namespace laver
