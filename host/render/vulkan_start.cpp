#include "render/vulkan_start.h"

#include <fmt/format.h>

#include "render/stopwatch.h"

namespace laver {
namespace {

/// The traversal to run: `wanted`, or the faster one that the device can. Throws Error.
std::string traversalFor(const Device& device, const std::string& wanted) {
  std::string best = bestTraversal(device.info());
  if (wanted.empty()) return best;
  if (wanted == "packet" && best != "packet")
    throw Error(ExitCode::Device,
                fmt::format("traversal packet needs subgroups of 8 lanes that shuffle; {} has {}",
                            device.name(), device.info().subgroupSize));
  if (wanted != "packet" && wanted != "lane")
    throw Error(ExitCode::Usage, fmt::format("no traversal is named \"{}\"; there are lane and "
                                             "packet",
                                             wanted));
  return wanted;
}

}  // namespace

std::string bestTraversal(const DeviceInfo& device) {
  return device.subgroupSize == 8 && device.shuffles ? "packet" : "lane";
}

StartedVulkan::StartedVulkan(const VulkanOptions& options)
    : instance(options.validate), device(choosePhysicalDevice(instance, options.device)) {}

std::unique_ptr<StartedVulkan> startVulkan(const VulkanOptions& options) {
  double seconds = 0;
  std::unique_ptr<StartedVulkan> vulkan;
  {
    const Stopwatch watch(seconds);
    vulkan = std::make_unique<StartedVulkan>(options);
  }
  vulkan->traversal = traversalFor(vulkan->device, options.traversal);
  vulkan->seconds = seconds;
  return vulkan;
}

}  // namespace laver
