#include "render/renderer.h"

#include <fmt/format.h>

#include <future>
#include <numeric>
#include <optional>

#include "core/parallel.h"
#include "render/device_scene.h"
#include "render/kernels.h"
#include "render/plan.h"
#include "render/resolve.h"
#include "render/stopwatch.h"
#include "render/traversal.h"
#include "render/vulkan_start.h"

namespace laver {
namespace {

/// A stride that visits all of 0 .. rows - 1 in an even mix: coprime to rows, near 0.618 of it.
std::uint32_t rowStride(std::uint32_t rows) {
  auto stride = std::max(1U, static_cast<std::uint32_t>(0.618 * rows));
  while (std::gcd(stride, rows) != 1) ++stride;
  return stride;
}

std::uint32_t groups(std::uint32_t count, std::uint32_t size) { return (count + size - 1) / size; }

std::string traceName(Integrator integrator, const std::string& traversal) {
  return std::string(integratorName(integrator)) + "_" + traversal;
}

/// One picture: bands outside, passes inside.
class Render {
 public:
  Render(const Device& device, const SceneData& data, const RenderPlan& plan, const Scene& scene,
         const RenderOptions& options, Stats& stats)
      : device_(device), data_(data), plan_(plan), scene_(scene), options_(options), stats_(stats) {
    const Stopwatch watch(stats.seconds.upload);
    onDevice_.emplace(device, data, plan);
    // Touched for the first time here, while kernels may still be compiled.
    onDevice_->film().fillZero();
    image_ = rgbImage(plan.core.x1 - plan.core.x0, plan.core.y1 - plan.core.y0);
  }

  /// Takes kernels that were compiled with `constants`.
  void take(Kernels kernels, const SpecConstants& constants) {
    trace_ = std::move(kernels.trace);
    gather_ = std::move(kernels.gather);
    if (constants != data_.constants) compileTrace();  // a deeper stack than was guessed
  }

  Image run() {
    const Crop core = plan_.core;
    std::vector<std::byte> copy;
    for (int y = core.y0; y < core.y1; y += static_cast<int>(plan_.bandRows)) {
      const Crop band{core.x0, y, core.x1, std::min(core.y1, y + static_cast<int>(plan_.bandRows))};
      if (y != core.y0) onDevice_->film().fillZero();
      const std::uint32_t samples = renderBand(band);
      if (samples == 0) break;
      stats_.reached.addRows(band.y1 - band.y0, samples, scene_.sampler.sampleCount);
      const Stopwatch watch(stats_.seconds.readBack);
      const std::size_t bytes = static_cast<std::size_t>(band.x1 - band.x0) *
                                static_cast<std::size_t>(band.y1 - band.y0) *
                                sizeof(shared::FilmPixel);
      resolve(onDevice_->film().contents(bytes, copy), y - core.y0, image_, options_.threads);
      ++stats_.bands;
      if (samples != scene_.sampler.sampleCount) break;
    }
    stats_.droppedSamples = status_.dropped;
    return std::move(image_);
  }

 private:
  static std::span<const std::byte> bytes(const shared::Pass& pass) {
    return std::as_bytes(std::span(&pass, 1));
  }

  void compileTrace() {
    const Stopwatch watch(stats_.seconds.compile);
    trace_ = compileKernel(device_, onDevice_->bindings(),
                           traceName(scene_.integrator, stats_.traversal), data_.constants);
  }

  /// Returns how many samples a pixel the band got.
  std::uint32_t renderBand(const Crop& band) {
    shared::Pass pass{};
    pass.region = regionOf(band, data_.constants[shared::SPEC_APRON], scene_.camera.width,
                           scene_.camera.height);
    pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
    const std::uint32_t samples = scene_.sampler.sampleCount;
    for (std::uint32_t first = 0; first < samples; first += plan_.samplesAPass) {
      if (options_.stop && options_.stop()) return first;
      pass.samples.x = first;
      pass.samples.y = std::min(plan_.samplesAPass, samples - first);
      tracePass(pass);
      const Stopwatch watch(stats_.seconds.reconstruct);
      pass.tiles = {plan_.gatherRows, 0, 0, 0};
      device_.run([&](VkCommandBuffer commands) {
        gather_->dispatch(
            commands, onDevice_->bindings(), bytes(pass),
            {groups(pass.core.z, shared::GATHER_GROUP), groups(pass.core.w, plan_.gatherRows), 1});
      });
      ++stats_.passes;
      stats_.samples += std::uint64_t{pass.core.z} * pass.core.w * pass.samples.y;
      reportProgress(band, first + pass.samples.y);
    }
    return samples;
  }

  /// Traces the samples of a pass. Where a packet of rays meets more of the scene than one
  /// invocation may walk through, this pass and all that follow go ray by ray: the same bits.
  void tracePass(const shared::Pass& pass) {
    const shared::Status before = status_;
    dispatchPass(pass);
    if (status_.incomplete != 0 && stats_.traversal == "packet") {
      stats_.traversal = "lane";
      stats_.leftOut.emplace_back(
          fmt::format("packets: {} of them ran more loops than the driver lets one invocation run",
                      status_.incomplete / 8));
      compileTrace();
      onDevice_->status().upload(std::as_bytes(std::span(&before, 1)));
      dispatchPass(pass);
    }
    if (status_.incomplete != 0)
      throw Error(ExitCode::Device,
                  fmt::format("{} rays were not traced to their end: the driver lets one "
                              "invocation run too few loop iterations",
                              status_.incomplete));
  }

  /// All lights in one dispatch, or a few in each of several.
  void dispatchPass(shared::Pass pass) {
    const Stopwatch watch(stats_.seconds.trace);
    const auto lights = static_cast<std::uint32_t>(data_.lights.size());
    std::uint32_t first = 0;
    do {
      const std::uint32_t count = std::min(lights - first, shared::LIGHTS_A_DISPATCH);
      pass.lights = {first, count, first == 0 ? 1 : 0, first + count == lights ? 1 : 0};
      device_.run([&](VkCommandBuffer commands) { dispatchSamples(commands, pass); });
      first += count;
    } while (first < lights);
    onDevice_->status().download(std::as_writable_bytes(std::span(&status_, 1)));
  }

  /// As many samples of a pixel side by side as there are: 16, 4 or 1 in a tile of 64.
  void dispatchSamples(VkCommandBuffer commands, shared::Pass pass) const {
    std::uint32_t done = 0;
    for (const std::uint32_t shift : {4U, 2U, 0U}) {
      const std::uint32_t count = (pass.samples.y - done) >> shift;
      if (count == 0) continue;
      const std::uint32_t side = 8U >> shift / 2;
      const std::uint32_t rows = groups(pass.region.w, side);
      pass.tiles = {rows, rowStride(rows), shift, done};
      trace_->dispatch(commands, onDevice_->bindings(), bytes(pass),
                       {groups(pass.region.z, side), rows, count});
      done += count << shift;
    }
  }

  void reportProgress(const Crop& band, std::uint32_t samplesDone) const {
    if (!options_.progress) return;
    const double rows = plan_.core.y1 - plan_.core.y0;
    const double share = static_cast<double>(samplesDone) / scene_.sampler.sampleCount;
    options_.progress((band.y0 - plan_.core.y0 + share * (band.y1 - band.y0)) / rows);
  }

  const Device& device_;
  const SceneData& data_;
  const RenderPlan& plan_;
  const Scene& scene_;
  const RenderOptions& options_;
  Stats& stats_;
  std::optional<DeviceScene> onDevice_;
  std::optional<Kernel> trace_, gather_;
  shared::Status status_{};
  Image image_;
};

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
  const SpecConstants constants = generalise(specialise(scene, options), impl_->options.generic);
  std::uint64_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) {
    triangles += mesh.triangles.size();
    stats.droppedTriangles += mesh.droppedTriangles;
  }
  // Beside the building of the tree: the rest of the device's start, and the kernels.
  auto compiling = std::async(std::launch::async, [&] {
    const StartedVulkan& vulkan = *impl_->vulkan.get();
    stats.traversal = vulkan.traversal;
    if (impl_->options.traversal.empty() && tooDenseForPackets(triangles, scene))
      stats.traversal = "lane";
    const Stopwatch watch(stats.seconds.compile);
    return compileKernels(vulkan.device, traceName(scene.integrator, stats.traversal), constants);
  });
  const SceneData data = packScene(scene, options, constants);
  stats.describe(data);

  const StartedVulkan& vulkan = *impl_->vulkan.get();
  const Device& device = vulkan.device;
  stats.device = device.name();
  stats.driver = device.driver();
  stats.seconds.vulkanStart = vulkan.seconds;
  const Crop core = options.crop.value_or(Crop{0, 0, scene.camera.width, scene.camera.height});
  const RenderPlan plan = planRender(device.limits(), core, scene.camera.width, scene.camera.height,
                                     data.constants[shared::SPEC_APRON], scene.sampler.sampleCount,
                                     impl_->options.samplesInFlight);
  stats.samplesAPass = plan.samplesAPass;
  stats.samples = 0;
  stats.reached = {};
  Render picture(device, data, plan, scene, options, stats);
  picture.take(compiling.get(), constants);
  Image image = picture.run();
  vulkan.instance.throwIfInvalid();
  return image;
}

}  // namespace laver
