#include "render/renderer.h"

#include <fmt/format.h>

#include <future>
#include <optional>
#include <utility>

#include "render/kernels.h"
#include "render/passes.h"
#include "render/plan.h"
#include "render/render_pictures.h"
#include "render/stopwatch.h"
#include "render/vulkan_start.h"

namespace laver {
namespace {

/// A packet walks through all that its 64 rays see: with many triangles to a ray, rays by
/// themselves are sooner done. A bunny of 1.1 million triangles at one sample a pixel, 1 and 17
/// triangles to a ray: packets take 0.3 and 2.8 times as long as rays by themselves.
bool tooDenseForPackets(std::uint64_t triangles, const Scene& scene) {
  const std::uint64_t rays = static_cast<std::uint64_t>(scene.camera.width) *
                             static_cast<std::uint64_t>(scene.camera.height) *
                             std::min(scene.sampler.sampleCount, 16U);
  return triangles > 5 * rays;
}

/// 64 samples of a pixel side by side share more of a fine mesh, and less of the film: a bunny of
/// 1.9 triangles to a pixel is traced 1.25 times as fast as by 16, one of 0.08 0.95 times.
std::uint32_t sideBySide(std::uint64_t triangles, const Camera& camera) {
  const auto pixels =
      static_cast<std::uint64_t>(camera.width) * static_cast<std::uint64_t>(camera.height);
  return triangles > pixels ? 64 : 16;
}

}  // namespace

struct Renderer::Impl {
  VulkanOptions options;
  std::shared_future<std::unique_ptr<StartedVulkan>> vulkan;
};

Renderer::Renderer(const VulkanOptions& options) : impl_(new Impl{options, {}}) {
  impl_->vulkan =
      std::async(std::launch::async, [options] { return startVulkan(options); }).share();
}

Renderer::~Renderer() = default;

Image Renderer::render(const Scene& scene, const RenderOptions& options, Stats& stats) {
  FilmState nothing;
  return render(scene, options, nothing, stats);
}

Image Renderer::render(const Scene& scene, const RenderOptions& options, FilmState& state,
                       Stats& stats) {
  std::vector<Rendering> pictures = renderingsOf(scene, options, impl_->options.generic);
  std::uint64_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) {
    triangles += mesh.primitives();
    stats.droppedTriangles += mesh.droppedTriangles;
  }
  // Beside the building of the tree: the rest of the device's start, and the kernels.
  auto compiling = std::async(std::launch::async, [&] {
    const StartedVulkan& vulkan = *impl_->vulkan.get();
    stats.traversal = vulkan.traversal;
    if (impl_->options.traversal.empty() && tooDenseForPackets(triangles, scene))
      stats.traversal = "lane";
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
  const Crop core = options.crop.value_or(Crop{0, 0, scene.camera.width, scene.camera.height});
  const Settings settings = state.keep() == FilmState::Keep::Nothing
                                ? Settings{}
                                : settingsOf(scene, data, core, device.info());
  state.begin(settings, core.x1 - core.x0, core.y1 - core.y0, scene.sampler.sampleCount);
  const glm::uvec4 region =
      regionOf(core, data.constants[shared::SPEC_APRON], scene.camera.width, scene.camera.height);
  const Crop planned = options.error == 0.0
                           ? core
                           : pilotArea(cropOf(region), scene.camera.width, scene.camera.height);
  const RenderPlan plan =
      planRender(device.limits(), planned, scene.camera.width, scene.camera.height,
                 data.constants[shared::SPEC_APRON], scene.sampler.sampleCount,
                 impl_->options.samplesInFlight, sideBySide(triangles, scene.camera));
  stats.samplesAPass = plan.samplesAPass;
  stats.samples = 0;
  stats.reached = {};
  stats.adaptive = {options.error};
  std::optional<Passes> passes;
  {
    const Stopwatch watch(stats.seconds.upload);
    passes.emplace(device, data, plan, scene, options, stats);
  }
  passes->take(compiling.get());
  Image image = renderPictures(*passes, {data, plan, scene, options, core}, std::move(pictures),
                               state, stats);
  vulkan.instance.throwIfInvalid();
  return image;
}

}  // namespace laver
