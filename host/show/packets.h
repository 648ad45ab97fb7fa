#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace laver {

/// Packets that the viewers tev and HDRView read from a socket. Little-endian: u32 length of the
/// packet with these four bytes, u8 operation, payload; strings end in NUL.

/// Operation 4: a black picture, shown at once.
std::vector<std::byte> createImagePacket(const std::string& name, int width, int height,
                                         const std::vector<std::string>& channels);

/// Operation 6: new values of `rows` whole rows from row `y` on, channels interleaved.
std::vector<std::byte> updateImagePacket(const std::string& name,
                                         const std::vector<std::string>& channels, int y, int width,
                                         int rows, std::span<const float> pixels);

}  // namespace laver
