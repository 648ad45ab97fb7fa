#pragma once
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "image/bitmap.h"
#include "image/image.h"

namespace laver {

/// Attributes of an EXR file by name. Matrices follow glm's column-vector convention.
using Metadata = std::map<std::string, std::variant<std::string, double, int, glm::dmat4>>;

/// Writes 32-bit float channels with the picture's window as the data window, the film as the
/// display window, ZIP-compressed on `threads` threads (0: all). Replaces the file
/// atomically. Throws Error(Output).
void writeExr(const std::string& file, const Image& image, const Metadata& metadata = {},
              unsigned threads = 0);

/// The bytes of that file, whose name errors tell.
std::vector<std::byte> encodeExr(const std::string& file, const Image& image,
                                 const Metadata& metadata, unsigned threads);

/// Reads every channel of an EXR file as float, over its data window. Channels are sorted by layer
/// and name, except that R, G, B, A of a layer come first. Luminance and chroma become R, G, B. Of
/// several parts it is the first. Throws Error(Usage) if the file cannot be read or is deep.
Image readExr(const std::string& file);

/// The string attributes of an EXR file, by name. Throws Error(Usage) if it is no EXR file.
std::map<std::string, std::string> readExrTexts(const std::string& file);

/// The attributes of an EXR file, as writeExr() takes them; without those that every file has.
/// Throws Error(Usage) if it is no EXR file.
Metadata readExrMetadata(const std::string& file);

/// The kind of image, which determines how a PNG is compressed.
enum class PngContent { Render, Drawing };
/// Replaces the file atomically. Throws Error(Output).
void writePng(const std::string& file, const Bitmap& bitmap,
              PngContent content = PngContent::Render);

/// The bytes of a PNG file; errors tell its name. An image's R, G, B become 8-bit sRGB, clamped and
/// rounded to nearest. Throws Error(Output).
std::vector<std::byte> encodePng(const Bitmap& bitmap, const std::string& name = "PNG in memory");
std::vector<std::byte> encodePng(const Image& image, const std::string& name = "PNG in memory");

}  // namespace laver
