#include <ImathMatrix.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "image/atomic_file.h"
#include "image/image_defect.h"
#include "image/io.h"

namespace laver {
namespace {

/// A file in memory for OpenEXR, which goes back to fill in its table of lines.
class MemoryStream final : public Imf::OStream {
 public:
  explicit MemoryStream(const char* name) : OStream(name) {}

  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (bytes_.size() < position_ + size) bytes_.resize(position_ + size);
    std::memcpy(bytes_.data() + position_, bytes, size);
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::vector<std::byte> takeBytes() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

/// Puts one metadata value into the header as the attribute type that pbrt uses for it.
struct AttributeWriter {
  Imf::Header& header;
  const std::string& name;

  void operator()(const std::string& text) const {
    header.insert(name, Imf::StringAttribute(text));
  }
  void operator()(double number) const {
    header.insert(name, Imf::FloatAttribute(static_cast<float>(number)));
  }
  void operator()(int number) const { header.insert(name, Imf::IntAttribute(number)); }
  /// Imath multiplies row vectors from the left, so row i of its matrix is glm's column i.
  void operator()(const glm::dmat4& matrix) const {
    Imath::M44f rows;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) rows[i][j] = static_cast<float>(matrix[i][j]);
    }
    header.insert(name, Imf::M44fAttribute(rows));
  }
};

std::vector<std::byte> encode(const Image& image, const Metadata& metadata, const char* name,
                              unsigned threads) {
  const int workers = static_cast<int>(threadCount(threads));
  // One pool serves the whole process; it never shrinks below what another call asked for.
  if (Imf::globalThreadCount() < workers) Imf::setGlobalThreadCount(workers);
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, value] : metadata) std::visit(AttributeWriter{header, key}, value);

  const Imath::Box2i window = header.dataWindow();
  const std::size_t stride = image.channels.size() * sizeof(float);
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    header.channels().insert(image.channels[c], Imf::Channel(Imf::FLOAT));
    frame.insert(image.channels[c],
                 Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, window, stride,
                                  stride * static_cast<std::size_t>(image.width)));
  }
  MemoryStream stream(name);
  {
    Imf::OutputFile output(stream, header, workers);
    output.setFrameBuffer(frame);
    output.writePixels(image.height);
  }  // the table of lines is written here
  return stream.takeBytes();
}

}  // namespace

void writeExr(const std::string& file, const Image& image, const Metadata& metadata,
              unsigned threads) {
  std::string reason = imageDefect(image);
  std::vector<std::byte> bytes;
  if (reason.empty()) {
    try {
      bytes = encode(image, metadata, file.c_str(), threads);
    } catch (const std::exception& error) {
      reason = error.what();
      std::replace(reason.begin(), reason.end(), '\n', ' ');
    }
  }
  if (!reason.empty()) {
    throw Error(ExitCode::Output, fmt::format("cannot write \"{}\": {}", file, reason));
  }
  replaceFile(file, bytes);
}

}  // namespace laver
