#pragma once
#include <memory>
#include <string>

#include "render/renderer.h"
#include "vulkan/device.h"

namespace laver {

/// A device that is ready.
struct StartedVulkan {
  explicit StartedVulkan(const VulkanOptions& options);
  Instance instance;
  Device device;
  double seconds = 0;  ///< that the start took
};

/// Throws Error(Device).
std::unique_ptr<StartedVulkan> startVulkan(const VulkanOptions& options);

}  // namespace laver
