#include "render/scene_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/packed.h"
#include "render/reasons.h"
#include "render/renderer.h"
#include "render/scene_coverage.h"
#include "render/stats.h"

namespace laver {
namespace {

Reason tree(const Choices& choices, const Bvh& bvh) {
  if (!choices.uploads.primitives) return {"tree", "not built", "no ray is traced", "", 0};
  return {
      "tree",
      fmt::format("{} of up to 8 children, depth {}", countOf(bvh.nodes.size(), "node"), bvh.depth),
      "built for this plan, to find its depth", "", 0};
}

Reason stack(std::uint32_t guess, std::uint32_t needed) {
  const std::uint32_t entries = stackFor(guess, needed);
  const std::string choice = countOf(entries, "entry", "entries");
  if (entries != guess)
    return {"stack", choice, fmt::format("the tree needs {}: the kernel is compiled again", needed),
            "", 0};
  return {"stack", choice,
          fmt::format(
              "the tree needs {}; set before the tree is built, so that kernels compile meanwhile",
              needed),
          "", 0};
}

double coverage(const Choices& choices, const Packed& packed) {
  if (!choices.pictures.front().blackMiss) return 1.0;
  return coverageOf(packed).grown(static_cast<int>(choices.gather.apron)).share(choices.core);
}

nlohmann::json figuresOf(const Scene& scene, const RenderOptions& options, const Choices& choices,
                         const Packed& packed) {
  const Tiling& tiling = choices.tiling;
  const Crop core = choices.core;
  return {{"width", core.x1 - core.x0},
          {"height", rowsOf(choices.strips)},
          {"samples", scene.sampler.sampleCount},
          {"pictures", choices.pictures.size()},
          {"triangles", primitivesOf(scene)},
          {"nodes", packed.bvh.nodes.size()},
          {"depth", packed.bvh.depth},
          {"stackNeeded", packed.bvh.stack},
          {"stack", stackFor(choices.pictures.front().key.stack, packed.bvh.stack)},
          {"indexBytes", choices.uploads.indexBytes},
          {"bytesUploaded", bytesOf(packed)},
          {"sampleBytes", tiling.sampleSlots * kBytesInFlight},
          {"filmBytes", tiling.bandPixels * sizeof(shared::FilmPixel)},
          {"bands", bandsOf(choices.strips, tiling)},
          {"passesPerBand", passesOf(maxSamplesOf(scene, options), tiling)},
          {"samplesPerPass", tiling.samplesPerPass},
          {"samplesSideBySide", samplesSideBySide(tiling, options.error != 0.0)},
          {"seen", coverage(choices, packed)}};
}

}  // namespace

ScenePlan planScene(const Scene& scene, const RenderOptions& options, const VulkanOptions& vulkan,
                    const DeviceInfo& device) {
  const Choices choices = choose(scene, options, vulkan, device);
  const Packed packed = pack(scene, options, choices.uploads);
  ScenePlan plan{device.name, device.driver, traversalName(choices.traversal), choices.reasons,
                 figuresOf(scene, options, choices, packed)};
  plan.reasons.push_back(tree(choices, packed.bvh));
  plan.reasons.push_back(stack(choices.pictures.front().key.stack, packed.bvh.stack));
  return plan;
}

std::string ScenePlan::text() const {
  std::string out = fmt::format("{:<21}{} ({})\n", "device", device, driver);
  for (const Reason& reason : reasons) out += textOf(reason);
  out += fmt::format("{:<21}{:.1f} % of the film\n", "scene covers",
                     100.0 * figures["seen"].get<double>());
  return out + fmt::format("{:<21}{} bytes of scene\n", "uploads",
                           figures["bytesUploaded"].get<std::uint64_t>());
}

nlohmann::json ScenePlan::json() const {
  nlohmann::json lines = nlohmann::json::array();
  for (const Reason& reason : reasons) lines.push_back(jsonOf(reason));
  return {{"device", device},
          {"driver", driver},
          {"traversal", traversal},
          {"figures", figures},
          {"lines", lines}};
}

}  // namespace laver
