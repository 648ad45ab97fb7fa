#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "render/options.h"
#include "scene/scene.h"
#include "shared/layout.h"
#include "vulkan/device_info.h"

namespace laver {

/// DeviceScene adds as many to a texel buffer of 4-byte texels at most: 0x100 bytes and a texel.
inline constexpr std::uint32_t kMaxTexelsAdded = 0x100 / 4 + 1;

/// Bytes of a sample in flight in the larger of its two buffers, and in both.
inline constexpr std::uint64_t kSampleBytes = 16, kBytesInFlight = 20;

/// How a render is cut: bands of rows one after the other, each in passes of few samples, so that
/// memory grows neither with the film nor with the sample count and every dispatch is short.
struct Tiling {
  Crop planned;                  ///< pixels that are reconstructed: the core, or what pilots need
  std::uint32_t bandRows;        ///< rows of the core per band
  std::uint32_t samplesPerPass;  ///< all, or a multiple of GATHER_SAMPLES
  std::uint64_t sampleSlots;     ///< samples that the largest pass holds
  std::uint64_t bandPixels;      ///< pixels that the largest band reconstructs
  std::uint32_t gatherRows;      ///< rows of pixels that an invocation reconstructs
  std::uint32_t sideBySide;      ///< samples of a pixel that one workgroup traces at most: 16 or 64
};

/// What a film asks of its tiling.
struct TilingNeeds {
  Crop core;
  int width, height;             ///< of the film
  std::uint32_t apron, samples;  ///< per pixel
  std::uint64_t maxSlots = 0;    ///< samples in flight at most; 0: 2^22
  std::uint32_t sideBySide = 16;
};

/// Throws Error(Device) where the device cannot hold even the smallest piece.
Tiling tile(const VkPhysicalDeviceLimits& limits, const TilingNeeds& needs);

/// Bands of a core, and passes of a band of that many samples per pixel.
std::uint32_t bandsOf(const Crop& core, const Tiling& tiling);
std::uint32_t passesOf(std::uint32_t samples, const Tiling& tiling);

/// Samples of a pixel that a workgroup traces side by side: 1, 4, 16 or 64. Adaptive sampling's
/// lists of work go by 16 at most.
std::uint32_t samplesBeside(const Tiling& tiling, bool adaptive);

/// Region (core with the apron, cut to the film) as x, y, width, height.
glm::uvec4 regionOf(Crop core, std::uint32_t apron, int width, int height);

inline Crop cropOf(glm::uvec4 r) {
  return {static_cast<int>(r.x), static_cast<int>(r.y), static_cast<int>(r.x + r.z),
          static_cast<int>(r.y + r.w)};
}

/// A stride that visits all of 0 .. rows - 1 in an even mix: coprime to rows, near 0.618 of it.
std::uint32_t rowStride(std::uint32_t rows);

/// Pixels on each side of a sample's own that a filter of that radius can reach.
std::uint32_t apronOf(double radius);

}  // namespace laver
