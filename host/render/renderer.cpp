#include "render/renderer.h"

#include <chrono>
#include <future>
#include <utility>

#include "core/beside.h"
#include "render/render.h"
#include "render/stopwatch.h"
#include "vulkan/device.h"

namespace laver {
namespace {

/// A device after start-up.
struct StartedVulkan {
  explicit StartedVulkan(const VulkanOptions& options)
      : instance(options.validate), device(choosePhysicalDevice(instance, options.device)) {}
  Instance instance;
  Device device;
};

struct Start {
  std::unique_ptr<StartedVulkan> vulkan;
  double seconds = 0;
};

Start startVulkan(const VulkanOptions& options) {
  Start start;
  const Stopwatch watch(start.seconds);
  start.vulkan = std::make_unique<StartedVulkan>(options);
  return start;
}

}  // namespace

struct Renderer::Impl {
  VulkanOptions options;
  std::shared_future<Start> start;
  KeptKernels kept{};  // destroyed before the device
};

Renderer::Renderer(const VulkanOptions& options) : impl_(new Impl{options, {}}) {
  impl_->start = std::async(kBeside, [options] { return startVulkan(options); }).share();
}

Renderer::~Renderer() = default;

Rendered Renderer::render(const Scene& scene, const RenderOptions& options, Stats& stats) {
  FilmState nothing;
  return render(scene, options, nothing, stats);
}

Rendered Renderer::render(const Scene& scene, const RenderOptions& options, FilmState& state,
                          Stats& stats) {
  const Start& start = impl_->start.get();
  const Device& device = start.vulkan->device;
  const Choices choices = choose(scene, options, impl_->options, device.info());

  double compileSeconds = 0;
  auto compiling = std::async(kBeside, [&] {
    const Stopwatch watch(compileSeconds);
    return compileKernels(device, choices.pictures.front().key, choices.gather,
                          attributeFormat(choices.uploads),
                          impl_->options.keepsKernels ? &impl_->kept : nullptr);
  });
  const Packed packed = pack(scene, options, choices.uploads);
  Observers observers(options.observers);
  observers.started(device.name());
  Settings settings;
  if (options.shard || state.keep() != FilmState::Keep::Nothing)
    settings = settingsOf(scene, packed, choices, device.info());
  if (options.shard) settings.emplace_back("shard", textOf(*options.shard));
  state.begin(settings, choices.core.x1 - choices.core.x0, rowsOf(choices.strips),
              scene.sampler.sampleCount);

  while (compiling.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout)
    observers.waiting();
  Frame frame(device, packed, choices, std::move(compiling));
  if (impl_->options.poisoned) frame.poison();
  RenderTimes times;
  times.adaptive.error = options.error;
  const Rendered rendered =
      renderLoop(frame, {scene, options, choices, packed, observers}, state, times);
  start.vulkan->instance.throwIfInvalid();
  observers.finished(rendered.image);

  stats.device = device.name();
  stats.driver = device.driver();
  stats.seconds.vulkanStart = start.seconds;
  stats.seconds.compile = compileSeconds;
  stats.add(scene, choices, packed);
  stats.add(frame.work(), times, rendered);
  return rendered;
}

}  // namespace laver
