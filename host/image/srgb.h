#pragma once
#include <cstdint>

namespace laver {

/// Linear light to the sRGB transfer curve of IEC 61966-2-1, clamped to [0, 1], times 255, rounded
/// to nearest. NaN gives 0.
std::uint8_t srgb8(float linear);

}  // namespace laver
