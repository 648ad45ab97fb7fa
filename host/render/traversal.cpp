#include "render/traversal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace laver {
namespace {

/// `wanted`, or what the device runs best.
std::string traversalFor(const DeviceInfo& device, const std::string& wanted) {
  std::string best = bestTraversal(device);
  if (wanted.empty()) return best;
  if (wanted != "lane" && wanted != "packet" && wanted != "packet32" && wanted != "packet64")
    throw Error(ExitCode::Usage, fmt::format("no traversal is named \"{}\"; there are lane, "
                                             "packet, packet32 and packet64",
                                             wanted));
  if (wanted.starts_with("packet") && best != "packet")
    throw Error(ExitCode::Device,
                fmt::format("traversal {} needs subgroups of 8 lanes that shuffle, and 64-bit "
                            "integers; {} has subgroups of {}{}{}",
                            wanted, device.name, device.subgroupSize,
                            device.shuffles ? "" : " that do not shuffle",
                            device.longs ? "" : ", and no such integers"));
  return wanted;
}

}  // namespace

std::string bestTraversal(const DeviceInfo& device) {
  return device.subgroupSize == 8 && device.shuffles && device.longs ? "packet" : "lane";
}

double trianglesARay(const Scene& scene) {
  const double rays = static_cast<double>(scene.camera.width) * scene.camera.height *
                      std::min(scene.sampler.sampleCount, 16U);
  return static_cast<double>(primitivesOf(scene)) / rays;
}

std::string fasterPackets(const Scene& scene) {
  return trianglesARay(scene) > 0.25 ? "packet32" : "packet64";
}

Chosen traversalOf(const Scene& scene, const DeviceInfo& device, const std::string& wanted) {
  const std::string traversal = traversalFor(device, wanted);
  if (wanted == traversal && wanted != "packet") return {wanted, "asked for"};
  if (traversal == "lane")
    return {traversal, "no subgroups of 8 lanes that shuffle, or no 64-bit integers"};
  const double density = trianglesARay(scene);
  const std::string size = fmt::format("{:.2g} triangles to a ray", density);
  if (wanted.empty() && density > 2.0) return {"lane", size};
  const std::uint64_t rays = static_cast<std::uint64_t>(scene.camera.width) *
                             static_cast<std::uint64_t>(scene.camera.height) *
                             scene.sampler.sampleCount;
  if (rays < kManyRays) return {"packet32", "few rays, so that compiling counts"};
  return {fasterPackets(scene), size};
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
