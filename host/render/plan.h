#pragma once
#include <cstdint>
#include <vector>

#include "render/options.h"
#include "scene/scene.h"
#include "shared/layout.h"
#include "vulkan/device.h"

namespace laver {

/// DeviceScene adds as many to a texel buffer of 4-byte texels at most: 0x100 bytes and a texel.
inline constexpr std::uint32_t kMostTexelsAdded = 0x100 / 4 + 1;

/// How a render is cut: bands of rows one after the other, each in passes of few samples, so that
/// memory grows neither with the film nor with the sample count and every dispatch is short.
struct RenderPlan {
  Crop core;                   ///< what is wanted, film pixels
  std::uint32_t bandRows;      ///< rows of the core a band
  std::uint32_t samplesAPass;  ///< all, or a multiple of GATHER_SAMPLES
  std::uint64_t sampleSlots;   ///< samples that the largest pass holds
  std::uint64_t bandPixels;    ///< pixels that the largest band reconstructs
  std::uint32_t gatherRows;    ///< rows of pixels that an invocation reconstructs
  std::uint32_t sideBySide;    ///< the most samples of a pixel that one workgroup traces: 16 or 64
};

/// Cuts a film of `width` x `height` pixels. At most `maxSlots` samples are in flight (0: 2^22).
/// `sideBySide` as in the plan; a pass holds as many samples of a pixel if there is room.
/// Throws Error(Device) where the device cannot hold even the smallest piece.
RenderPlan planRender(const VkPhysicalDeviceLimits& limits, Crop core, int width, int height,
                      std::uint32_t apron, std::uint32_t samples, std::uint64_t maxSlots,
                      std::uint32_t sideBySide = 16);

/// Cuts the film of a scene, or what the options crop of it.
RenderPlan planRender(const VkPhysicalDeviceLimits& limits, const Scene& scene,
                      const RenderOptions& options, std::uint32_t apron, std::uint64_t maxSlots);

/// Region (core rows [y0, y1) with the apron, cut to the film) as x, y, width, height.
glm::uvec4 regionOf(Crop core, std::uint32_t apron, int width, int height);

inline Crop cropOf(glm::uvec4 r) {
  return {static_cast<int>(r.x), static_cast<int>(r.y), static_cast<int>(r.x + r.z),
          static_cast<int>(r.y + r.w)};
}

/// A stride that visits all of 0 .. rows - 1 in an even mix: coprime to rows, near 0.618 of it.
std::uint32_t rowStride(std::uint32_t rows);

/// Bytes of a sample in flight in the larger of its two buffers.
inline constexpr std::uint64_t kSampleBytes = 16;

}  // namespace laver
