#include <cstdio>  // jpeglib.h wants FILE
// jpeglib.h must precede jerror.h.
#include <jpeglib.h>
//
#include <jerror.h>

#include <array>
#include <csetjmp>
#include <stdexcept>

#include "image/picture.h"

namespace laver {
namespace {

/// libjpeg reports errors by longjmp, so no function that it may leave holds an object with a
/// destructor.
class JpegReader {
 public:
  JpegReader() {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = fail;
    errors_.emit_message = warn;
    jpeg_.client_data = this;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  bool readHeader(std::span<const std::byte> bytes) {
    if (setjmp(back_) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_read_header(&jpeg_, TRUE);
    jpeg_.out_color_space = JCS_RGB;
    return true;
  }

  bool readRows(Bitmap& bitmap) {
    if (setjmp(back_) != 0) return false;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = bitmap.at(0, static_cast<int>(jpeg_.output_scanline)).data();
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

  std::size_t width() const { return jpeg_.image_width; }
  std::size_t height() const { return jpeg_.image_height; }
  bool printed() const {
    return jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
  }

  [[noreturn]] void refuse() const { throw std::runtime_error(reason_.data()); }

 private:
  static void fail(j_common_ptr jpeg) {
    auto* self = static_cast<JpegReader*>(jpeg->client_data);
    jpeg->err->format_message(jpeg, self->reason_.data());
    std::longjmp(self->back_, 1);
  }

  /// Level -1 is either damage, which libjpeg would fill in, or an oddity that changes no pixel.
  static void warn(j_common_ptr jpeg, int level) {
    const int code = jpeg->err->msg_code;
    const bool harmless = code == JWRN_EXTRANEOUS_DATA || code == JWRN_ADOBE_XFORM ||
                          code == JWRN_JFIF_MAJOR || code == JWRN_TOO_MUCH_DATA;
    if (level < 0 && !harmless) fail(jpeg);
  }

  jpeg_decompress_struct jpeg_{};
  jpeg_error_mgr errors_{};
  std::jmp_buf back_{};
  std::array<char, JMSG_LENGTH_MAX> reason_{};
};

}  // namespace

Bitmap decodeJpeg(std::span<const std::byte> bytes) {
  JpegReader reader;
  if (!reader.readHeader(bytes)) reader.refuse();
  if (reader.printed())
    throw std::runtime_error("it holds inks (CMYK), and RGB or grey pictures are read");
  checkPictureSize(reader.width(), reader.height());
  Bitmap bitmap(static_cast<int>(reader.width()), static_cast<int>(reader.height()), {});
  if (!reader.readRows(bitmap)) reader.refuse();
  return bitmap;
}

}  // namespace laver
