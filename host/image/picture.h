#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <variant>

#include "image/bitmap.h"
#include "image/image.h"

namespace laver {

/// The content of an image file: 8 bits per channel, as stored, or linear floats R, G, B.
using Picture = std::variant<Bitmap, Image>;

/// Width and height in pixels.
int widthOf(const Picture& picture);
int heightOf(const Picture& picture);

/// Linear value in [0, 1] of an encoded value in [0, 1], by the sRGB curve of IEC 61966-2-1.
double linearOfSrgb(double encoded);

/// Reads PNG, JPEG or OpenEXR; the first bytes of the file decide which. Alpha is dropped, grey is
/// copied to R, G and B. 16-bit PNGs are decoded to linear floats, or with `raw` only divided by
/// 65535. EXR is linear and must be finite. Throws Error(Usage): one line with the file and the
/// reason.
Picture readPicture(const std::string& file, bool raw);

/// Decodes a file in memory. Throws std::runtime_error with the reason alone.
Picture decodePng(std::span<const std::byte> bytes, bool raw);
Bitmap decodeJpeg(std::span<const std::byte> bytes);

/// Throws std::runtime_error for images that are empty, over 2^27 pixels or over 2^16 on a side.
/// The readers of PNG and JPEG call it before they allocate memory for the size in the file.
void checkPictureSize(std::size_t width, std::size_t height);

}  // namespace laver
