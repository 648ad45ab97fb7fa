#include "render/traversal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace laver {
namespace {

void requirePackets(const DeviceInfo& device, const std::string& wanted) {
  if (runsPackets(device)) return;
  throw Error(ExitCode::Device,
              fmt::format("traversal {} needs subgroups of 8 lanes with shuffles, and 64-bit "
                          "integers; {} has subgroups of {}{}{}",
                          wanted, device.name, device.subgroupSize,
                          device.shuffles ? "" : " without shuffles",
                          device.longs ? "" : ", and no 64-bit integers"));
}

}  // namespace

bool runsPackets(const DeviceInfo& device) {
  return device.subgroupSize == 8 && device.shuffles && device.longs;
}

double trianglesPerRay(const Scene& scene) {
  const double rays = static_cast<double>(scene.camera.width) * scene.camera.height *
                      std::min(scene.sampler.sampleCount, 16U);
  return static_cast<double>(primitivesOf(scene)) / rays;
}

Traversal fasterPackets(const Scene& scene) {
  return trianglesPerRay(scene) > 0.25 ? Traversal::Packet32 : Traversal::Packet64;
}

TraversalChoice traversalOf(const Scene& scene, const DeviceInfo& device,
                            const std::string& wanted) {
  const bool packet = wanted == "packet";
  if (!wanted.empty() && !packet) {
    for (const Traversal traversal : {Traversal::Lane, Traversal::Packet32, Traversal::Packet64})
      if (wanted == traversalName(traversal)) {
        if (isPacket(traversal)) requirePackets(device, wanted);
        return {traversal, "requested"};
      }
    throw Error(ExitCode::Usage, fmt::format("no traversal is named \"{}\"; there are lane, "
                                             "packet, packet32 and packet64",
                                             wanted));
  }
  if (packet) requirePackets(device, wanted);
  if (!runsPackets(device))
    return {Traversal::Lane, "no subgroups of 8 lanes with shuffles, or no 64-bit integers"};
  const double density = trianglesPerRay(scene);
  const std::string size = fmt::format("{:.2g} triangles per ray", density);
  if (!packet && density > 2.0) return {Traversal::Lane, size};
  const std::uint64_t rays = static_cast<std::uint64_t>(scene.camera.width) *
                             static_cast<std::uint64_t>(scene.camera.height) *
                             scene.sampler.sampleCount;
  if (rays < kManyRays) return {Traversal::Packet32, "few rays, so that compile time matters"};
  return {fasterPackets(scene), size};
}

float packetWindow(std::uint64_t primitives) {
  const double window =
      8.0 / std::sqrt(static_cast<double>(std::max<std::uint64_t>(primitives, 1)));
  return static_cast<float>(std::clamp(window, 0.02, 1.0));
}

std::uint32_t sideBySide(const Scene& scene) {
  const auto pixels = static_cast<std::uint64_t>(scene.camera.width) *
                      static_cast<std::uint64_t>(scene.camera.height);
  return primitivesOf(scene) > pixels ? 64 : 16;
}

}  // namespace laver
