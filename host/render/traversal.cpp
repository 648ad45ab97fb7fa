#include "render/traversal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace laver {

std::string bestTraversal(const DeviceInfo& device) {
  return device.subgroupSize == 8 && device.shuffles && device.longs ? "packet" : "lane";
}

std::string traversalFor(const DeviceInfo& device, const std::string& wanted) {
  std::string best = bestTraversal(device);
  if (wanted.empty()) return best;
  if (wanted == "packet" && best != "packet")
    throw Error(
        ExitCode::Device,
        fmt::format("traversal packet needs subgroups of 8 lanes that shuffle, and 64-bit "
                    "integers; {} has subgroups of {}{}{}",
                    device.name, device.subgroupSize, device.shuffles ? "" : " that do not shuffle",
                    device.longs ? "" : ", and no such integers"));
  if (wanted != "packet" && wanted != "lane")
    throw Error(ExitCode::Usage, fmt::format("no traversal is named \"{}\"; there are lane and "
                                             "packet",
                                             wanted));
  return wanted;
}

bool tooDenseForPackets(const Scene& scene) {
  const std::uint64_t rays = static_cast<std::uint64_t>(scene.camera.width) *
                             static_cast<std::uint64_t>(scene.camera.height) *
                             std::min(scene.sampler.sampleCount, 16U);
  return primitivesOf(scene) > kMostTrianglesARay * rays;
}

float packetWindow(std::uint64_t primitives) {
  const double alike = 8.0 / std::sqrt(static_cast<double>(std::max<std::uint64_t>(primitives, 1)));
  return static_cast<float>(std::clamp(alike, 0.02, 1.0));
}

std::uint32_t sideBySide(const Scene& scene) {
  const auto pixels = static_cast<std::uint64_t>(scene.camera.width) *
                      static_cast<std::uint64_t>(scene.camera.height);
  return primitivesOf(scene) > pixels ? 64 : 16;
}

}  // namespace laver
