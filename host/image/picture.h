#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <variant>

#include "image/bitmap.h"
#include "image/image.h"

namespace laver {

/// A picture of a file: 8 bits a channel as the file has them, or linear floats R, G, B.
using Picture = std::variant<Bitmap, Image>;

/// Width and height of a picture, pixels.
int widthOf(const Picture& picture);
int heightOf(const Picture& picture);

/// Linear light, in [0, 1], of a value in [0, 1] that the sRGB curve of IEC 61966-2-1 encodes.
double linearOfSrgb(double encoded);

/// Reads PNG, JPEG or OpenEXR, as the file's first bytes say. Alpha is left out, grey is spread to
/// R, G and B. 16-bit PNGs are decoded to linear floats, or with `raw` only divided by 65535. EXR
/// is linear and must be finite. Throws Error(Usage): one line that names the file and the reason.
Picture readPicture(const std::string& file, bool raw);

/// The same of a file's bytes; throws std::runtime_error with the reason alone.
Picture decodePng(std::span<const std::byte> bytes, bool raw);
Bitmap decodeJpeg(std::span<const std::byte> bytes);

/// Throws std::runtime_error for pictures of more than 2^27 pixels or 2^16 on a side: no size is
/// believed before it is looked at.
void checkPictureSize(std::size_t width, std::size_t height);

}  // namespace laver
