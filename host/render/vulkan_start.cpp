#include "render/vulkan_start.h"

#include "render/stopwatch.h"

namespace laver {
StartedVulkan::StartedVulkan(const VulkanOptions& options)
    : instance(options.validate), device(choosePhysicalDevice(instance, options.device)) {}

std::unique_ptr<StartedVulkan> startVulkan(const VulkanOptions& options) {
  double seconds = 0;
  std::unique_ptr<StartedVulkan> vulkan;
  {
    const Stopwatch watch(seconds);
    vulkan = std::make_unique<StartedVulkan>(options);
  }
  vulkan->seconds = seconds;
  return vulkan;
}

}  // namespace laver
