#include "render/renderer.h"

#include <fmt/format.h>

#include <array>
#include <future>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "render/device_scene.h"
#include "render/kernels.h"
#include "render/plan.h"
#include "render/resolve.h"
#include "render/sampler_data.h"
#include "render/stopwatch.h"
#include "render/vulkan_start.h"
#include "render/work_list.h"

namespace laver {
namespace {

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

/// log2 of how many samples of a pixel are traced side by side.
constexpr std::array<std::uint32_t, 4> kShifts = {6, 4, 2, 0};

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
         const RenderOptions& options, Crop core, Stats& stats)
      : device_(device),
        data_(data),
        plan_(plan),
        scene_(scene),
        options_(options),
        core_(core),
        stats_(stats) {
    const Stopwatch watch(stats.seconds.upload);
    onDevice_.emplace(device, data, plan);
    // Touched for the first time here, while kernels may still be compiled.
    onDevice_->film().fillZero();
    image_ = rgbImage(core.x1 - core.x0, core.y1 - core.y0);
  }

  /// Takes kernels that were compiled with `constants`.
  void take(Kernels kernels, const SpecConstants& constants) {
    trace_ = std::move(kernels.trace);
    gather_ = std::move(kernels.gather);
    if (constants != data_.constants) compileTrace();  // a deeper stack than was guessed
  }

  Image run() {
    if (options_.error == 0.0) {
      renderFilm(core_, scene_.sampler.sampleCount, image_);
    } else if (const auto map = runPilots()) {
      map_ = &*map;
      renderFilm(core_, mostOf(scene_.sampler), image_);
      stats_.adaptive.describe(*map, core_, mostOf(scene_.sampler));
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

  /// Pictures of one sample a pixel of all that the counts of the core's samples depend on. None if
  /// stopped.
  std::optional<SampleMap> runPilots() {
    const Crop area = plan_.core;
    const SampleMap one(area, 1);
    map_ = &one;
    std::vector<Image> pilots;
    shared::Params params = data_.params;
    for (int i = 0; i < kPilots; ++i) {
      packSeed(pilotSeed(scene_.sampler.seed, i), params);
      onDevice_->upload(params);
      pilots.push_back(rgbImage(area.x1 - area.x0, area.y1 - area.y0));
      renderFilm(area, 1, pilots.back());
      const bool whole = stats_.reached.wholeRows == pilots.back().height;
      stats_.reached = {};
      if (!whole) return {};
    }
    onDevice_->upload(data_.params);
    status_.dropped = 0;
    onDevice_->status().upload(std::as_bytes(std::span(&status_, 1)));
    stats_.adaptive.pilotSamples = std::exchange(stats_.samples, 0);
    return decideSamples(pilots, area, options_.error, mostOf(scene_.sampler), options_.threads);
  }

  /// `samples` a pixel, or as many of them as the map says.
  void renderFilm(Crop core, std::uint32_t samples, Image& image) {
    std::vector<std::byte> copy;
    for (int y = core.y0; y < core.y1; y += static_cast<int>(plan_.bandRows)) {
      const Crop band{core.x0, y, core.x1, std::min(core.y1, y + static_cast<int>(plan_.bandRows))};
      if (std::exchange(filmUsed_, true)) onDevice_->film().fillZero();
      const std::uint32_t done = renderBand(band, samples);
      if (done == 0) break;
      stats_.reached.addRows(band.y1 - band.y0, done, samples);
      const Stopwatch watch(stats_.seconds.readBack);
      const std::size_t bytes = static_cast<std::size_t>(band.x1 - band.x0) *
                                static_cast<std::size_t>(band.y1 - band.y0) *
                                sizeof(shared::FilmPixel);
      resolve(onDevice_->film().contents(bytes, copy), y - core.y0, image, options_.threads);
      ++stats_.bands;
      if (done != samples) break;
    }
  }

  /// Returns how many of `samples` a pixel the band got.
  std::uint32_t renderBand(const Crop& band, std::uint32_t samples) {
    shared::Pass pass{};
    pass.region = regionOf(band, data_.constants[shared::SPEC_APRON], scene_.camera.width,
                           scene_.camera.height);
    pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
    const std::uint32_t most = map_ != nullptr ? map_->most(cropOf(pass.region)) : samples;
    if (map_ != nullptr) onDevice_->upload(map_->counts(pass.region));
    std::uint32_t done = 0;
    while (done < most && !(options_.stop && options_.stop())) {
      pass.samples.x = done;
      pass.samples.y = std::min(plan_.samplesAPass, most - done);
      tracePass(pass);
      gatherPass(pass);
      ++stats_.passes;
      done += pass.samples.y;
      reportProgress(band, static_cast<double>(done) / most);
    }
    stats_.samples += map_ != nullptr ? map_->samplesOf(band, done)
                                      : std::uint64_t{pass.core.z} * pass.core.w * done;
    return done == most ? samples : done;
  }

  /// Traces the samples of a pass. Where a packet of rays meets more of the scene than one
  /// invocation may walk through, this pass and all that follow go ray by ray: the same bits.
  void tracePass(const shared::Pass& pass) {
    const shared::Status before = status_;
    if (map_ != nullptr) listWork(pass);
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
    if (map_ != nullptr) {
      for (std::size_t i = 0; i < kShifts.size(); ++i) {
        pass.tiles.z = kShifts[i];
        dispatch(commands, *trace_, pass, tracing_[i]);
      }
      return;
    }
    std::uint32_t done = 0;
    for (const std::uint32_t shift : kShifts) {
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

  void gatherPass(shared::Pass pass) {
    const Stopwatch watch(stats_.seconds.reconstruct);
    pass.tiles = {map_ != nullptr ? shared::STRIP_ROWS : plan_.gatherRows, 0, 0, 0};
    device_.run([&](VkCommandBuffer commands) {
      if (map_ != nullptr)
        dispatch(commands, *gather_, pass, gathering_);
      else
        gather_->dispatch(commands, onDevice_->bindings(), bytes(pass),
                          {groups(pass.core.z + pass.core.x - pass.region.x, shared::GATHER_GROUP),
                           groups(pass.core.w, plan_.gatherRows), 1});
    });
  }

  /// Lists the work of a pass where cells have counts of their own.
  void listWork(const shared::Pass& pass) {
    std::vector<shared::Work> list;
    for (std::size_t i = 0; i < kShifts.size(); ++i)
      tracing_[i] = listTracing(*map_, pass, kShifts[i], list);
    gathering_ = listGathering(*map_, pass, data_.constants[shared::SPEC_APRON], list);
    onDevice_->upload(list);
  }

  void dispatch(VkCommandBuffer commands, const Kernel& kernel, shared::Pass pass,
                const WorkRange& work) const {
    if (work.rows == 0) return;
    pass.tiles.w = work.first;
    kernel.dispatch(commands, onDevice_->bindings(), bytes(pass), {work.columns, work.rows, 1});
  }

  /// `share` of the band is done.
  void reportProgress(const Crop& band, double share) const {
    if (!options_.progress || (map_ != nullptr && stats_.adaptive.pilotSamples == 0)) return;
    const double rows = core_.y1 - core_.y0;
    options_.progress((band.y0 - core_.y0 + share * (band.y1 - band.y0)) / rows);
  }

  const Device& device_;
  const SceneData& data_;
  const RenderPlan& plan_;
  const Scene& scene_;
  const RenderOptions& options_;
  const Crop core_;
  Stats& stats_;
  std::optional<DeviceScene> onDevice_;
  std::optional<Kernel> trace_, gather_;
  shared::Status status_{};
  Image image_;
  bool filmUsed_ = false;
  const SampleMap* map_ = nullptr;  ///< adaptive sampling only, as what follows
  std::array<WorkRange, kShifts.size()> tracing_{};
  WorkRange gathering_{};
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
  Render picture(device, data, plan, scene, options, core, stats);
  picture.take(compiling.get(), constants);
  Image image = picture.run();
  vulkan.instance.throwIfInvalid();
  return image;
}

}  // namespace laver
