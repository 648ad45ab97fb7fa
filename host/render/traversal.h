#pragma once
#include <cstdint>
#include <string>

#include "scene/scene.h"
#include "vulkan/device_info.h"

namespace laver {

/// The faster traversal that the device can run: "packet" where subgroups have 8 lanes that
/// shuffle and integers may have 64 bits, else "lane". A scene too dense for packets goes by lane
/// all the same.
std::string bestTraversal(const DeviceInfo& device);

/// The traversal to run: `wanted`, or the faster one that the device can. Throws Error(Usage) for
/// an unknown one and Error(Device) where the device cannot.
std::string traversalFor(const DeviceInfo& device, const std::string& wanted);

/// A packet walks through all that its 64 rays see: with many triangles to a ray, rays by
/// themselves are sooner done. Of bunnies of 69,666 and 1.1 million triangles with 1.1, 1.9 and 4.2
/// to a ray, packets take 0.5 to 0.9, 0.8 to 1 and 1.6 times as long as rays by themselves.
inline constexpr std::uint64_t kMostTrianglesARay = 2;
bool tooDenseForPackets(const Scene& scene);

/// How far from its leader's the slopes of a ray may be that walks with it in a packet: of a coarse
/// mesh wide packets meet few triangles more, and a packet that falls apart walks once for each
/// part. 192x192 pixels at one sample: a Cornell box is traced in 0.3 of the time that 0.02 takes;
/// of bunny-whitted 0.01 to 0.05 are within a tenth, 0.2 takes 1.2 times as long.
float packetWindow(std::uint64_t primitives);

/// 64 samples of a pixel side by side share more of a fine mesh, and less of the film: a bunny of
/// 1.9 triangles to a pixel is traced 1.25 times as fast as by 16, one of 0.08 0.95 times.
std::uint32_t sideBySide(const Scene& scene);

}  // namespace laver
