#include "render/renderer.h"

#include <fmt/format.h>

#include <future>
#include <numeric>
#include <optional>

#include "core/parallel.h"
#include "core/sparing.h"
#include "render/device_scene.h"
#include "render/kernels.h"
#include "render/pictures.h"
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

std::string traceName(const Picture& picture, const std::string& traversal) {
  return picture.kernel + "_" + traversal;
}

/// Pictures of one scene, one after the other: bands outside, passes inside.
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

  /// Takes kernels that were compiled for the first picture.
  void take(Kernels kernels) {
    trace_ = std::move(kernels.trace);
    gather_ = std::move(kernels.gather);
  }

  /// All of them in one image; black where there is no time for them.
  Image run(std::vector<Picture> pictures) {
    std::vector<Image> parts;
    bool whole = true;
    for (Picture& picture : pictures) {
      const SpecConstants guess = picture.constants;
      requireStack(picture.constants, data_.bvh.stack);
      picture_ = &picture;
      share_ = {static_cast<double>(parts.size()), 1.0 / static_cast<double>(pictures.size())};
      const bool first = parts.empty();
      if (first ? guess != picture.constants : whole) compileTrace();
      if (!first) image_ = blackImage(parts[0].width, parts[0].height, picture.channels);
      Reached reached;
      parts.push_back(render(whole, reached));
      whole = whole && reached.wholeRows == parts.back().height;
      if (first)
        stats_.reached = reached;
      else if (!whole)
        ++stats_.reached.unfinished;
    }
    stats_.droppedSamples = status_.dropped;
    if (asks(options_.layers, Layer::Samples)) parts.push_back(samplesLayer(parts.front()));
    return joined(std::move(parts));
  }

 private:
  Image render(bool wanted, Reached& reached) {
    const Crop core = plan_.core;
    const std::uint32_t samples = picture_->centres ? 1 : scene_.sampler.sampleCount;
    for (int y = core.y0; y < core.y1 && wanted; y += static_cast<int>(plan_.bandRows)) {
      const Crop band{core.x0, y, core.x1, std::min(core.y1, y + static_cast<int>(plan_.bandRows))};
      const std::uint32_t done = picture_->centres ? traceCentres(band) : renderBand(band);
      if (done == 0) break;
      reached.addRows(band.y1 - band.y0, done, samples);
      showBand(band);
      ++stats_.bands;
      if (done != samples) break;
    }
    return std::move(image_);
  }

  Image samplesLayer(const Image& picture) const {
    Image image = blackImage(picture.width, picture.height, {"samples"});
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        image.at(x, y, 0) =
            static_cast<float>(stats_.reached.samplesIn(y, scene_.sampler.sampleCount));
    return image;
  }

  /// Resolves what a band has and tells the watcher, if it is the first picture's.
  void showBand(const Crop& band) {
    sparing_.run([&] {
      resolveBand(band);
      if (watched())
        options_.watcher.rowsChanged(image_, band.y0 - plan_.core.y0, band.y1 - plan_.core.y0);
    });
  }

  bool watched() const { return options_.watcher.rowsChanged && share_.before == 0.0; }

  void resolveBand(const Crop& band) {
    const Stopwatch watch(stats_.seconds.readBack);
    const std::size_t bytes = static_cast<std::size_t>(band.x1 - band.x0) *
                              static_cast<std::size_t>(band.y1 - band.y0) *
                              sizeof(shared::FilmPixel);
    const auto film = onDevice_->film().contents(bytes, copy_);
    const int row = band.y0 - plan_.core.y0;
    if (picture_->centres)
      resolveCentres(film, row, scene_, data_.space, options_, image_);
    else
      resolve(film, row, image_, options_.threads);
  }

  /// One ray through the centre of each pixel; returns 1, or 0 if it was stopped before.
  std::uint32_t traceCentres(const Crop& band) {
    if (options_.stop && options_.stop()) return 0;
    shared::Pass pass{};
    pass.region = pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
    pass.samples.y = 1;
    filmIsClear_ = false;
    tracePass(pass);
    return 1;
  }

  static std::span<const std::byte> bytes(const shared::Pass& pass) {
    return std::as_bytes(std::span(&pass, 1));
  }

  void compileTrace() {
    const Stopwatch watch(stats_.seconds.compile);
    trace_ = compileKernel(device_, onDevice_->bindings(), traceName(*picture_, stats_.traversal),
                           picture_->constants);
  }

  /// Returns how many samples a pixel the band got.
  std::uint32_t renderBand(const Crop& band) {
    shared::Pass pass{};
    pass.region = regionOf(band, data_.constants[shared::SPEC_APRON], scene_.camera.width,
                           scene_.camera.height);
    pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
    const std::uint32_t samples = scene_.sampler.sampleCount;
    if (!filmIsClear_) onDevice_->film().fillZero();
    filmIsClear_ = false;
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
      if (first + pass.samples.y < samples && watched() && sparing_.due()) showBand(band);
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
    const bool lit = picture_->constants[shared::SPEC_LIGHTS] != shared::LIGHTS_NONE;
    const auto lights = lit ? static_cast<std::uint32_t>(data_.lights.size()) : 0U;
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
    const double picture = (band.y0 - plan_.core.y0 + share * (band.y1 - band.y0)) / rows;
    options_.progress((share_.before + picture) * share_.each);
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
  const Picture* picture_ = nullptr;
  struct {
    double before = 0.0, each = 1.0;
  } share_;  ///< of the picture: how many are done, its part of all
  bool filmIsClear_ = true;
  Image image_;
  std::vector<std::byte> copy_;
  Sparing sparing_{options_.watcher.share};
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
  std::vector<Picture> pictures = picturesOf(scene, options, impl_->options.generic);
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
    return compileKernels(vulkan.device, traceName(pictures.front(), stats.traversal),
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
  const RenderPlan plan = planRender(device.limits(), core, scene.camera.width, scene.camera.height,
                                     data.constants[shared::SPEC_APRON], scene.sampler.sampleCount,
                                     impl_->options.samplesInFlight);
  stats.samplesAPass = plan.samplesAPass;
  stats.samples = 0;
  stats.reached = {};
  Render render(device, data, plan, scene, options, stats);
  render.take(compiling.get());
  Image image = render.run(std::move(pictures));
  vulkan.instance.throwIfInvalid();
  return image;
}

}  // namespace laver
