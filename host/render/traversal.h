#pragma once
#include <cstdint>
#include <string>

#include "kernels/keys.h"
#include "scene/scene.h"
#include "vulkan/device_info.h"

namespace laver {

/// Whether a device runs packets: its subgroups have 8 lanes that shuffle, and integers may have 64
/// bits.
bool runsPackets(const DeviceInfo& device);

/// A packet walks through all that its rays see: the more triangles there are to a ray, the fewer
/// rays should share a walk. More than 16 samples of a pixel share no more. A bunny of 69,666
/// triangles, traced by packets of 64 and of 32 rays, in times of rays by themselves: 0.29 and 0.30
/// at 0.12 triangles to a ray, 0.39 and 0.39 at 0.27, 0.76 and 0.54 at 1.1, 1.2 and 0.67 at 1.9,
/// 1.4 and 0.88 at 2.7, where rays are few and their own kernel is sooner compiled.
double trianglesPerRay(const Scene& scene);

/// Of packets of 32 and of 64 rays those that trace a scene sooner, compiling left out.
Traversal fasterPackets(const Scene& scene);

/// From so many camera rays on, packets of 64 rays save more than their kernel takes longer to
/// compile: 5 to 12 ns a ray, and 20 to 60 ms. At 2.1 to 2.4 million whole processes take as long.
inline constexpr std::uint64_t kManyRays = std::uint64_t{1} << 22;

struct TraversalChoice {
  Traversal traversal;
  std::string why;
};

/// What traces a scene. `wanted` is lane, packet, packet32, packet64, or empty: what the device
/// runs best, but lane where triangles are too many for packets. Of packets, unless their size is
/// asked for, those that are sooner done. Throws Error(Usage) for an unknown one and Error(Device)
/// where the device cannot.
TraversalChoice traversalOf(const Scene& scene, const DeviceInfo& device,
                            const std::string& wanted);

/// How far from its leader's the slopes of a ray may be that walks with it in a packet: of a coarse
/// mesh wide packets meet few triangles more, and a packet that falls apart walks once for each
/// part. 192x192 pixels at one sample: a Cornell box is traced in 0.3 of the time that 0.02 takes;
/// of bunny-whitted 0.01 to 0.05 are within a tenth, 0.2 takes 1.2 times as long.
float packetWindow(std::uint64_t primitives);

/// 64 samples of a pixel side by side share more of a fine mesh, and less of the film: a bunny of
/// 1.9 triangles to a pixel is traced 1.25 times as fast as by 16, one of 0.08 0.95 times.
std::uint32_t sideBySide(const Scene& scene);

}  // namespace laver
