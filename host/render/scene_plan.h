#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/choices.h"
#include "render/options.h"
#include "scene/scene.h"

namespace laver {

/// The choices of a render without rendering, and the numbers that only the tree has.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON asserts, and throws nothing
struct ScenePlan {
  std::string device, driver, traversal;
  std::vector<Reason> reasons;
  nlohmann::json figures;
  std::string text() const;
  nlohmann::json json() const;
};

/// Chooses and packs the scene; compiles no kernel and uploads nothing. Throws like rendering.
ScenePlan planScene(const Scene& scene, const RenderOptions& options, const VulkanOptions& vulkan,
                    const DeviceInfo& device);

}  // namespace laver
