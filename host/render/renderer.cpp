#include "render/renderer.h"

#include <fmt/format.h>

#include <future>
#include <optional>
#include <utility>

#include "render/kernels.h"
#include "render/passes.h"
#include "render/plan.h"
#include "render/resolve.h"
#include "render/sampler_data.h"
#include "render/stopwatch.h"
#include "render/traversal.h"
#include "render/vulkan_start.h"

namespace laver {
namespace {

std::string traceName(Integrator integrator, const std::string& traversal) {
  return std::string(integratorName(integrator)) + "_" + traversal;
}

/// One picture: bands outside, passes inside.
class Render {
 public:
  Render(Passes& passes, const SceneData& data, const RenderPlan& plan, const Scene& scene,
         const RenderOptions& options, Crop core, FilmState& state, Stats& stats)
      : passes_(passes),
        data_(data),
        plan_(plan),
        scene_(scene),
        options_(options),
        core_(core),
        state_(state),
        stats_(stats),
        image_(rgbImage(core.x1 - core.x0, core.y1 - core.y0)) {}

  Image run() {
    if (options_.error == 0.0) {
      renderKept();
    } else if (const auto map = runPilots()) {
      passes_.use(&*map);
      map_ = &*map;
      renderFilm(core_, mostOf(scene_.sampler), image_);
      stats_.adaptive.describe(*map, core_, mostOf(scene_.sampler));
    }
    state_.dropped += passes_.dropped();
    stats_.droppedSamples = state_.dropped;
    return std::move(image_);
  }

 private:
  /// All samples of the picture, from what its state holds on.
  void renderKept() {
    const int height = image_.height;
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
  }

  /// Brings rows of the picture, which fit into a band, from `had` to all samples a pixel, or to
  /// where the render is ended; returns how many they have.
  std::uint32_t renderRows(int row, int rows, std::uint32_t had) {
    const Crop band{core_.x0, core_.y0 + row, core_.x1, core_.y0 + row + rows};
    if (had != 0)
      passes_.setFilm(state_.bytes(row, rows));
    else
      passes_.clearFilm();
    const std::uint32_t wanted = scene_.sampler.sampleCount;
    const auto passed = [&](std::uint32_t n) { reportProgress(band, n, wanted); };
    // Samples that are summed plainly are summed together, however often the render goes on.
    const bool always = state_.keep() == FilmState::Keep::Always;
    const std::uint32_t whole = always ? wanted - wanted % shared::GATHER_SAMPLES : wanted;
    std::uint32_t has = passes_.add(band, had, whole, passed);
    if (has != 0 && (always || (has != wanted && state_.keep() == FilmState::Keep::WhenEnded)))
      state_.take(row, rows, passes_.filmOf(band), has);
    if (has == whole && has != wanted) has = passes_.add(band, whole, wanted, passed);
    if (has == 0) return 0;
    showBand(band, row, image_);
    return has;
  }

  /// Pictures of one sample a pixel of all that the counts of the core's samples depend on. None if
  /// stopped.
  std::optional<SampleMap> runPilots() {
    const Crop area = plan_.core;
    const SampleMap one(area, 1);
    passes_.use(&one);
    std::vector<Image> pilots;
    shared::Params params = data_.params;
    for (int i = 0; i < kPilots; ++i) {
      packSeed(pilotSeed(scene_.sampler.seed, i), params);
      passes_.upload(params);
      pilots.push_back(rgbImage(area.x1 - area.x0, area.y1 - area.y0));
      renderFilm(area, 1, pilots.back());
      const bool whole = stats_.reached.wholeRows == pilots.back().height;
      stats_.reached = {};
      if (!whole) return {};
    }
    passes_.upload(data_.params);
    passes_.forgetDropped();
    stats_.adaptive.pilotSamples = std::exchange(stats_.samples, 0);
    return decideSamples(pilots, area, options_.error, mostOf(scene_.sampler), options_.threads);
  }

  /// As many samples as the map says, `samples` at most.
  void renderFilm(Crop core, std::uint32_t samples, Image& image) {
    for (int y = core.y0; y < core.y1; y += static_cast<int>(plan_.bandRows)) {
      const Crop band{core.x0, y, core.x1, std::min(core.y1, y + static_cast<int>(plan_.bandRows))};
      passes_.clearFilm();
      const std::uint32_t most = passes_.mostOf(band);
      std::uint32_t has = passes_.add(band, 0, most, [&](std::uint32_t n) {
        if (map_ != nullptr) reportProgress(band, n, most);
      });
      if (has == most) has = samples;
      if (has == 0) break;
      stats_.reached.addRows(band.y1 - band.y0, has, samples);
      showBand(band, y - core.y0, image);
      if (has != samples) break;
    }
  }

  void showBand(const Crop& band, int row, Image& image) {
    const Stopwatch watch(stats_.seconds.readBack);
    resolve(passes_.filmOf(band), row, image, options_.threads);
    ++stats_.bands;
  }

  /// A band has n of its samples.
  void reportProgress(const Crop& band, std::uint32_t n, std::uint32_t of) const {
    if (!options_.progress) return;
    const double share = static_cast<double>(n) / of;
    options_.progress((band.y0 - core_.y0 + share * (band.y1 - band.y0)) / image_.height);
  }

  Passes& passes_;
  const SceneData& data_;
  const RenderPlan& plan_;
  const Scene& scene_;
  const RenderOptions& options_;
  const Crop core_;
  FilmState& state_;
  Stats& stats_;
  Image image_;
  const SampleMap* map_ = nullptr;  ///< of adaptive sampling, once it is decided
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
  const Crop core = coreOf(scene, options);
  const Settings settings = state.keep() == FilmState::Keep::Nothing
                                ? Settings{}
                                : settingsOf(scene, data, core, device.info());
  state.begin(settings, core.x1 - core.x0, core.y1 - core.y0, scene.sampler.sampleCount);
  const RenderPlan plan =
      planRender(device.limits(), scene, options, data.constants[shared::SPEC_APRON],
                 impl_->options.samplesInFlight);
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
  // Anew for a deeper stack than was guessed.
  passes->begin(integratorName(scene.integrator), data.constants, constants == data.constants);
  Image image = Render(*passes, data, plan, scene, options, core, state, stats).run();
  vulkan.instance.throwIfInvalid();
  return image;
}

}  // namespace laver
