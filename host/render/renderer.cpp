#include "render/renderer.h"

#include <fmt/format.h>

#include <future>
#include <optional>
#include <utility>

#include "render/kernels.h"
#include "render/observer.h"
#include "render/passes.h"
#include "render/plan.h"
#include "render/render_pictures.h"
#include "render/stopwatch.h"
#include "render/traversal.h"
#include "render/vulkan_start.h"

namespace laver {

struct Renderer::Impl {
  VulkanOptions options;
  std::shared_future<std::unique_ptr<StartedVulkan>> vulkan;
};

Renderer::Renderer(const VulkanOptions& options) : impl_(new Impl{options, {}}) {
  impl_->vulkan =
      std::async(std::launch::async, [options] { return startVulkan(options); }).share();
}

Renderer::~Renderer() = default;

Rendered Renderer::render(const Scene& scene, const RenderOptions& options, Stats& stats) {
  FilmState nothing;
  return render(scene, options, nothing, stats);
}

Rendered Renderer::render(const Scene& scene, const RenderOptions& options, FilmState& state,
                          Stats& stats) {
  std::vector<Rendering> pictures = renderingsOf(scene, options, impl_->options.generic);
  if (impl_->options.wholeFilm)
    for (Rendering& picture : pictures) picture.blackMisses = false;
  for (const Mesh& mesh : scene.meshes) stats.droppedTriangles += mesh.droppedTriangles;
  // Beside the building of the tree: the rest of the device's start, and the kernels.
  auto compiling = std::async(std::launch::async, [&] {
    const StartedVulkan& vulkan = *impl_->vulkan.get();
    stats.traversal = traversalOf(scene, vulkan.device.info(), impl_->options.traversal).traversal;
    const Stopwatch watch(stats.seconds.compile);
    return compileKernels(vulkan.device, pictures.front().kernel + "_" + stats.traversal,
                          pictures.front().constants);
  });
  const SceneData data = packScene(scene, options, constantsOfAll(pictures));
  stats.describe(data);

  const StartedVulkan& vulkan = *impl_->vulkan.get();
  const Device& device = vulkan.device;
  stats.device = device.name();
  stats.driver = device.driver();
  stats.seconds.vulkanStart = vulkan.seconds;
  Observers observers(options.observers);
  observers.started(stats.device);
  const Crop core = coreOf(scene.camera, options);
  const Settings settings = state.keep() == FilmState::Keep::Nothing
                                ? Settings{}
                                : settingsOf(scene, data, core, device.info());
  state.begin(settings, core.x1 - core.x0, core.y1 - core.y0, scene.sampler.sampleCount);
  const RenderPlan plan =
      planRender(device.limits(), scene, options, data.constants[shared::SPEC_APRON],
                 impl_->options.samplesInFlight);
  stats.samplesAPass = plan.samplesAPass;
  stats.samples = 0;
  stats.adaptive = {options.error};
  std::optional<Passes> passes;
  {
    const Stopwatch watch(stats.seconds.upload);
    passes.emplace(device, data, plan, scene, options, stats);
  }
  if (impl_->options.poisoned) passes->poison();
  passes->take(compiling.get());
  Rendered rendered = renderPictures(*passes, {data, plan, scene, options, core, observers},
                                     std::move(pictures), state, stats);
  vulkan.instance.throwIfInvalid();
  return rendered;
}

}  // namespace laver
