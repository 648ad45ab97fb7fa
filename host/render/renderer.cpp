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

std::string traceName(Integrator integrator, const std::string& traversal) {
  return std::string(integratorName(integrator)) + "_" + traversal;
}

/// One picture: bands outside, passes inside.
class Render {
 public:
  Render(const Device& device, const SceneData& data, const RenderPlan& plan, const Scene& scene,
         const RenderOptions& options, FilmState& state, Stats& stats)
      : device_(device),
        data_(data),
        plan_(plan),
        scene_(scene),
        options_(options),
        state_(state),
        stats_(stats) {
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
    const int height = core.y1 - core.y0;
    const std::uint32_t wanted = scene_.sampler.sampleCount;
    bool ended = false;
    for (int row = 0, rows = 0; row < height; row += rows) {
      rows = state_.alike(row, std::min(height - row, static_cast<int>(plan_.bandRows)));
      std::uint32_t samples = state_.samples[static_cast<std::size_t>(row)];
      if (ended || samples == wanted) {
        if (samples != 0) resolve(state_.bytes(row, rows), row, image_, options_.threads);
      } else {
        samples = renderRows(row, rows, samples);
        if (samples != wanted && state_.keep() == FilmState::Keep::WhenEnded)
          state_.takeFinished(image_, row, wanted);
        ended = samples != wanted;
      }
      stats_.reached.addRows(rows, samples, wanted);
    }
    state_.dropped += status_.dropped;
    stats_.droppedSamples = state_.dropped;
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

  /// Brings rows of the picture, which fit into a band, from `had` to all samples a pixel, or to
  /// where the render is ended; returns how many they have.
  std::uint32_t renderRows(int row, int rows, std::uint32_t had) {
    const int y = plan_.core.y0 + row;
    const Crop band{plan_.core.x0, y, plan_.core.x1, y + rows};
    if (had != 0)
      onDevice_->film().upload(state_.bytes(row, rows));
    else if (stats_.bands != 0)
      onDevice_->film().fillZero();
    const std::uint32_t wanted = scene_.sampler.sampleCount;
    // Samples that are summed plainly are summed together, however often the render goes on.
    const bool always = state_.keep() == FilmState::Keep::Always;
    const std::uint32_t whole = always ? wanted - wanted % shared::GATHER_SAMPLES : wanted;
    std::uint32_t has = renderBand(band, had, whole);
    if (has != 0 && (always || (has != wanted && state_.keep() == FilmState::Keep::WhenEnded)))
      state_.take(row, rows, filmOf(band), has);
    if (has == whole && has != wanted) has = renderBand(band, whole, wanted);
    if (has == 0) return 0;
    const Stopwatch watch(stats_.seconds.readBack);
    resolve(filmOf(band), row, image_, options_.threads);
    ++stats_.bands;
    return has;
  }

  std::span<const std::byte> filmOf(const Crop& band) {
    const std::size_t pixels =
        static_cast<std::size_t>(band.x1 - band.x0) * static_cast<std::size_t>(band.y1 - band.y0);
    return onDevice_->film().contents(pixels * sizeof(shared::FilmPixel), copy_);
  }

  /// Adds samples [first, end) of every pixel; returns to which it came.
  std::uint32_t renderBand(const Crop& band, std::uint32_t first, std::uint32_t end) {
    shared::Pass pass{};
    pass.region = regionOf(band, data_.constants[shared::SPEC_APRON], scene_.camera.width,
                           scene_.camera.height);
    pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
    for (; first < end; first += pass.samples.y) {
      if (options_.stop && options_.stop()) return first;
      pass.samples.x = first;
      pass.samples.y = std::min(plan_.samplesAPass, end - first);
      tracePass(pass);
      const Stopwatch watch(stats_.seconds.reconstruct);
      pass.tiles = {plan_.gatherRows, 0, 0, 0};
      device_.run([&](VkCommandBuffer commands) {
        gather_->dispatch(commands, onDevice_->bindings(), bytes(pass),
                          {groups(pass.core.z + pass.core.x - pass.region.x, shared::GATHER_GROUP),
                           groups(pass.core.w, plan_.gatherRows), 1});
      });
      ++stats_.passes;
      stats_.samples += std::uint64_t{pass.core.z} * pass.core.w * pass.samples.y;
      reportProgress(band, first + pass.samples.y);
    }
    return end;
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

  /// As many samples of a pixel side by side as there are: 64, 16, 4 or 1 in a tile of 64.
  void dispatchSamples(VkCommandBuffer commands, shared::Pass pass) const {
    std::uint32_t done = 0;
    for (const std::uint32_t shift : {6U, 4U, 2U, 0U}) {
      if (1U << shift > plan_.sideBySide) continue;
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
  FilmState& state_;
  Stats& stats_;
  std::vector<std::byte> copy_;
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
  FilmState nothing;
  return render(scene, options, nothing, stats);
}

Image Renderer::render(const Scene& scene, const RenderOptions& options, FilmState& state,
                       Stats& stats) {
  const SpecConstants constants = specialise(scene, options, impl_->options.generic);
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
  const Settings settings = state.keep() == FilmState::Keep::Nothing
                                ? Settings{}
                                : settingsOf(scene, data, core, device.info());
  state.begin(settings, core.x1 - core.x0, core.y1 - core.y0, scene.sampler.sampleCount);
  const RenderPlan plan =
      planRender(device.limits(), core, scene.camera.width, scene.camera.height,
                 data.constants[shared::SPEC_APRON], scene.sampler.sampleCount,
                 impl_->options.samplesInFlight, sideBySide(triangles, scene.camera));
  stats.samplesAPass = plan.samplesAPass;
  stats.samples = 0;
  stats.reached = {};
  Render picture(device, data, plan, scene, options, state, stats);
  picture.take(compiling.get(), constants);
  Image image = picture.run();
  vulkan.instance.throwIfInvalid();
  return image;
}

}  // namespace laver
