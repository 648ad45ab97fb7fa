#pragma once
#include <cstdint>
#include <string>

#include "kernels/keys.h"
#include "scene/scene.h"
#include "vulkan/device_info.h"

namespace laver {

/// Whether a device supports packets: subgroups of 8 lanes with shuffles, and 64-bit integers.
bool runsPackets(const DeviceInfo& device);

/// A packet visits every node that any of its rays hits. The more triangles there are per ray, the
/// fewer rays should share a walk; more than 16 samples per pixel share no more nodes. Time of
/// packets of 64 and of 32 rays relative to single rays for a bunny of 69,666 triangles, by
/// triangles per ray: 0.29 and 0.30 at 0.12, 0.39 and 0.39 at 0.27, 0.76 and 0.54 at 1.1, 1.2 and
/// 0.67 at 1.9, 1.4 and 0.88 at 2.7. There, rays are few, and the kernel of `lane` compiles faster.
double trianglesPerRay(const Scene& scene);

/// The packet size, 32 or 64 rays, that traces a scene faster, without compilation.
Traversal fasterPackets(const Scene& scene);

/// From this number of camera rays on, packets of 64 rays save more than their longer compilation
/// costs: 5 to 12 ns per ray against 20 to 60 ms. Whole processes break even at 2.1 to 2.4 million
/// rays.
inline constexpr std::uint64_t kManyRays = std::uint64_t{1} << 22;

struct TraversalChoice {
  Traversal traversal;
  std::string why;
};

/// The traversal of a scene. `wanted` is lane, packet, packet32, packet64, or empty: packets if the
/// device supports them and triangles are not too many, else lane. If the packet size is not given,
/// the faster one including compilation. Throws Error(Usage) for an unknown name and Error(Device)
/// for one that the device does not support.
TraversalChoice traversalOf(const Scene& scene, const DeviceInfo& device,
                            const std::string& wanted);

/// Greatest difference between the slopes of a ray and the leader of its packet. Wider packets
/// visit few additional triangles of a coarse mesh, and a packet that is split walks once per part.
/// At 192x192 pixels and one sample: 1.0 traces a Cornell box in 0.3 of the time of 0.02; for
/// bunny-whitted 0.01 to 0.05 are within a tenth, and 0.2 takes 1.2 times as long.
float packetWindow(std::uint64_t primitives);

/// 64 samples of a pixel side by side share more of a fine mesh, but less of the film: compared
/// with 16, a bunny of 1.9 triangles per pixel is traced 1.25 times as fast, one of 0.08 triangles
/// 0.95 times.
std::uint32_t sideBySide(const Scene& scene);

}  // namespace laver
