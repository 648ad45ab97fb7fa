#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <tuple>

#include "core/error.h"
#include "core/lfs_pointer.h"
#include "image/io.h"

namespace laver {
namespace {

/// Sort key: by layer, and within a layer R, G, B, A before the other names.
auto channelOrder(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::size_t start = dot == std::string::npos ? 0 : dot + 1;
  const std::string last = name.substr(start);
  const std::size_t colour = last.size() == 1 ? std::string("RGBA").find(last) : std::string::npos;
  return std::tuple(name.substr(0, start), colour, last);
}

std::vector<std::string> channelNames(const Imf::ChannelList& list) {
  std::vector<std::string> names;
  for (auto channel = list.begin(); channel != list.end(); ++channel) {
    names.emplace_back(channel.name());
  }
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return channelOrder(a) < channelOrder(b);
  });
  return names;
}

/// Luminance and chroma, of which the latter have half the resolution, as OpenEXR converts them.
Image decodeChroma(const std::string& file, Image image) {
  Imf::RgbaInputFile input(file.c_str());
  const Imath::Box2i window = input.dataWindow();
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<Imf::Rgba> pixels(width * static_cast<std::size_t>(image.height));
  const std::ptrdiff_t origin =
      window.min.x + static_cast<std::ptrdiff_t>(window.min.y) * image.width;
  input.setFrameBuffer(pixels.data() - origin, 1, width);
  input.readPixels(window.min.y, window.max.y);
  image.channels = {"R", "G", "B"};
  for (const Imf::Rgba& p : pixels)
    image.pixels.insert(image.pixels.end(), {float{p.r}, float{p.g}, float{p.b}});
  return image;
}

/// EXR multiplies row vectors from the left, so row i of its matrix is glm's column i.
glm::dmat4 glmOf(const Imath::M44f& rows) {
  glm::dmat4 matrix;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) matrix[i][j] = static_cast<double>(rows[i][j]);
  return matrix;
}

Image decode(const std::string& file) {
  Imf::MultiPartInputFile input(file.c_str());
  const Imf::Header& header = input.header(0);
  if (header.hasType() && Imf::isDeepData(header.type())) {
    throw std::runtime_error("it holds deep data, and flat pictures are read");
  }
  const Imath::Box2i window = header.dataWindow();
  Image image;
  image.width = window.max.x - window.min.x + 1;
  image.height = window.max.y - window.min.y + 1;
  const Imath::Box2i display = header.displayWindow();
  image.window = {window.min.x - display.min.x, window.min.y - display.min.y,
                  display.max.x - display.min.x + 1, display.max.y - display.min.y + 1};
  const Imf::ChannelList& list = header.channels();
  if (list.findChannel("Y") && (list.findChannel("RY") || list.findChannel("BY")))
    return decodeChroma(file, std::move(image));
  image.channels = channelNames(list);
  const std::size_t row = static_cast<std::size_t>(image.width) * image.channels.size();
  const auto rows = static_cast<std::size_t>(image.height);
  if (row != 0 && rows > image.pixels.max_size() / row) throw std::runtime_error("it is too large");
  image.pixels.resize(row * rows);

  const std::size_t stride = image.channels.size() * sizeof(float);
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    frame.insert(image.channels[c], Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, window,
                                                     stride, row * sizeof(float)));
  }
  Imf::InputPart part(input, 0);
  part.setFrameBuffer(frame);
  part.readPixels(window.min.y, window.max.y);
  return image;
}

}  // namespace

Image readExr(const std::string& file) {
  std::string reason;
  errno = 0;
  if (!std::ifstream(file, std::ios::binary)) {
    reason = std::generic_category().message(errno);
  } else {
    try {
      return decode(file);
    } catch (const std::exception& error) {
      reason = error.what();
      std::replace(reason.begin(), reason.end(), '\n', ' ');
      std::string start(64, '\0');
      std::ifstream(file, std::ios::binary).read(start.data(), 64);
      if (isLfsPointer(start)) reason = std::string("it ") + kLfsPointer;
    }
  }
  throw Error(ExitCode::Usage, fmt::format("cannot read \"{}\": {}", file, reason));
}

Metadata readExrMetadata(const std::string& file) {
  try {
    const Imf::InputFile input(file.c_str());
    const Imf::Header& header = input.header();
    Metadata all;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
      const std::string name = attribute.name();
      if (name == "name" || name == "type" || name == "pixelAspectRatio" ||
          name == "screenWindowWidth")
        continue;
      const Imf::Attribute* const value = &attribute.attribute();
      if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(value))
        all[name] = text->value();
      else if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(value))
        all[name] = static_cast<double>(number->value());
      else if (const auto* whole = dynamic_cast<const Imf::IntAttribute*>(value))
        all[name] = whole->value();
      else if (const auto* matrix = dynamic_cast<const Imf::M44fAttribute*>(value))
        all[name] = glmOf(matrix->value());
    }
    return all;
  } catch (const std::exception&) {
    throw Error(ExitCode::Usage, fmt::format("cannot read \"{}\": it is no EXR file", file));
  }
}

std::map<std::string, std::string> readExrTexts(const std::string& file) {
  std::map<std::string, std::string> texts;
  for (const auto& [name, value] : readExrMetadata(file))
    if (const auto* text = std::get_if<std::string>(&value)) texts[name] = *text;
  return texts;
}

}  // namespace laver
