#include "show/packets.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace laver {
namespace {

static_assert(std::endian::native == std::endian::little, "packets hold little-endian numbers");

class Packet {
 public:
  explicit Packet(std::uint8_t operation) {
    add(std::uint32_t{0});
    add(operation);
  }

  template <class T>
  void add(T number) {
    append(&number, sizeof number);
  }
  void add(const std::string& text) { append(text.c_str(), text.size() + 1); }
  void add(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) add(text);
  }
  void add(std::span<const float> numbers) { append(numbers.data(), numbers.size_bytes()); }

  std::vector<std::byte> finish() {
    const auto length = static_cast<std::uint32_t>(bytes_.size());
    std::memcpy(bytes_.data(), &length, sizeof length);
    return std::move(bytes_);
  }

 private:
  void append(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  std::vector<std::byte> bytes_;
};

}  // namespace

std::vector<std::byte> createImagePacket(const std::string& name, int width, int height,
                                         const std::vector<std::string>& channels) {
  Packet packet(4);
  packet.add(std::uint8_t{1});  // takes the focus
  packet.add(name);
  packet.add(std::int32_t{width});
  packet.add(std::int32_t{height});
  packet.add(static_cast<std::int32_t>(channels.size()));
  packet.add(channels);
  return packet.finish();
}

std::vector<std::byte> updateImagePacket(const std::string& name,
                                         const std::vector<std::string>& channels, int y, int width,
                                         int rows, std::span<const float> pixels) {
  const auto count = static_cast<std::int64_t>(channels.size());
  Packet packet(6);
  packet.add(std::uint8_t{0});
  packet.add(name);
  packet.add(static_cast<std::int32_t>(count));
  packet.add(channels);
  for (const std::int32_t number : {0, y, width, rows}) packet.add(number);
  for (std::int64_t offset = 0; offset < count; ++offset) packet.add(offset);
  for (std::int64_t i = 0; i < count; ++i) packet.add(count);  // strides
  packet.add(pixels);
  return packet.finish();
}

}  // namespace laver
