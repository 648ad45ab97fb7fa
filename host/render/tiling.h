#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "render/options.h"
#include "render/strips.h"
#include "scene/scene.h"
#include "shared/layout.h"
#include "vulkan/device_info.h"

namespace laver {

/// Texels by which DeviceScene may enlarge a buffer of 4-byte texels: 0x100 bytes and a texel.
inline constexpr std::uint32_t kMaxTexelsAdded = 0x100 / 4 + 1;

/// Bytes per sample in flight, in the larger of its two buffers and in both.
inline constexpr std::uint64_t kSampleBytes = 16, kBytesInFlight = 20;

/// The division of a render into bands of rows, and of each band into passes of few samples, so
/// that memory grows neither with the film nor with the sample count and every dispatch is short.
struct Tiling {
  Crop planned;                  ///< pixels that are reconstructed together: a strip, or its pilots
  std::uint32_t bandRows;        ///< rows of the core per band
  std::uint32_t samplesPerPass;  ///< per pixel: all, or a multiple of GATHER_SAMPLES
  std::uint64_t sampleSlots;     ///< of the largest pass
  std::uint64_t bandPixels;      ///< of the largest band
  std::uint32_t gatherRows;      ///< rows of pixels per invocation
  std::uint32_t sideBySide;      ///< maximum of samples per pixel in one workgroup: 16 or 64
};

/// Input of tile().
struct TilingNeeds {
  Crop core;
  int width, height;             ///< of the film
  std::uint32_t apron, samples;  ///< per pixel
  std::uint64_t maxSlots = 0;    ///< maximum of samples in flight; 0: 2^22
  std::uint32_t sideBySide = 16;
};

/// Throws Error(Device) if the device cannot hold even the smallest piece.
Tiling tile(const VkPhysicalDeviceLimits& limits, const TilingNeeds& needs);

/// Number of bands of strips, and of passes of a band with that many samples per pixel.
std::uint32_t bandsOf(const std::vector<Strip>& strips, const Tiling& tiling);
std::uint32_t passesOf(std::uint32_t samples, const Tiling& tiling);

/// Samples per pixel that a workgroup traces side by side: 1, 4, 16 or 64. The work lists of
/// adaptive sampling use at most 16.
std::uint32_t samplesSideBySide(const Tiling& tiling, bool adaptive);

/// The region (the core with the apron, clipped to the film) as x, y, width, height.
glm::uvec4 regionOf(Crop core, std::uint32_t apron, int width, int height);

inline Crop cropOf(glm::uvec4 r) {
  return {static_cast<int>(r.x), static_cast<int>(r.y), static_cast<int>(r.x + r.z),
          static_cast<int>(r.y + r.w)};
}

/// Workgroups of `size` that hold `count`.
constexpr std::uint32_t groupsOf(std::uint32_t count, std::uint32_t size) {
  return (count + size - 1) / size;
}

/// A stride, coprime to `rows` and near 0.618 of it, that visits 0 .. rows - 1 evenly mixed.
std::uint32_t rowStride(std::uint32_t rows);

/// Pixels on each side of a sample's pixel that a filter of that radius can reach.
std::uint32_t apronOf(double radius);

}  // namespace laver
