#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/plan.h"
#include "render/scene_data.h"

namespace laver {

/// What a render of a scene would do, and what it would do without.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON asserts, and throws nothing
struct ScenePlan {
  struct Line {
    std::string what, decision, reason;
    std::string saving;  ///< beside bytes; empty: none
    std::uint64_t bytesNotUploaded = 0;
  };
  std::string device, driver, traversal;
  std::vector<Line> lines;
  nlohmann::json figures;  ///< the numbers that the lines tell of
  std::string text() const;
  nlohmann::json json() const;
};

/// Plans without rendering: the scene is packed, and its tree built, which alone tells how deep it
/// is; no kernel is compiled and nothing is uploaded. Throws as rendering does.
ScenePlan planScene(const Scene& scene, const RenderOptions& options,
                    const std::string& wantedTraversal, const DeviceInfo& device);

/// Bytes of geometry, attributes, lights and sampler tables that a render uploads.
std::uint64_t uploadedBytes(const SceneData& data);

}  // namespace laver
