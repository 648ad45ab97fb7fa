#include "render/passes.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/observer.h"
#include "render/projection.h"
#include "render/stopwatch.h"

namespace laver {
namespace {

std::uint32_t groups(std::uint32_t count, std::uint32_t size) { return (count + size - 1) / size; }

/// What a dispatch costs for itself, in samples.
constexpr double kDispatchSamples = 1000;

/// A part of an area as first and end column and row from its corner.
glm::uvec4 within(const Crop& part, const glm::uvec4& area) {
  const glm::uvec4 edges(part.x0, part.y0, part.x1, part.y1);
  return edges - glm::uvec4(area.x, area.y, area.x, area.y);
}

std::span<const std::byte> bytes(const shared::Pass& pass) {
  return std::as_bytes(std::span(&pass, 1));
}

}  // namespace

Passes::Passes(const Device& device, const SceneData& data, const RenderPlan& plan,
               const Scene& scene, const RenderOptions& options, Stats& stats)
    : device_(device),
      data_(data),
      plan_(plan),
      scene_(scene),
      options_(options),
      stats_(stats),
      onDevice_(device, data, plan),
      footprint_(footprintOf(data)),
      gatherable_(footprint_) {
  // Touched for the first time here, while kernels may still be compiled.
  onDevice_.film().fillZero();
}

void Passes::take(Kernels kernels) {
  trace_ = std::move(kernels.trace);
  gather_ = std::move(kernels.gather);
}

void Passes::begin(const Rendering& picture, bool taken) {
  kernel_ = picture.kernel;
  constants_ = picture.constants;
  gatherable_ = Footprint::whole(footprint_.width(), footprint_.height());
  if (picture.blackMisses) gatherable_ = footprint_.grown(apron());
  if (!taken) compileTrace();
}

void Passes::compileTrace() {
  const Stopwatch watch(stats_.seconds.compile);
  trace_ =
      compileKernel(device_, onDevice_.bindings(), kernel_ + "_" + stats_.traversal, constants_);
}

void Passes::clearFilm() {
  if (!filmIsClear_) onDevice_.film().fillZero();
  filmIsClear_ = false;
}

void Passes::setFilm(std::span<const std::byte> sums) {
  onDevice_.film().upload(sums);
  filmIsClear_ = false;
}

std::span<const std::byte> Passes::filmOf(const Crop& band) {
  const std::size_t pixels =
      static_cast<std::size_t>(band.x1 - band.x0) * static_cast<std::size_t>(band.y1 - band.y0);
  return onDevice_.film().contents(pixels * sizeof(shared::FilmPixel), copy_);
}

glm::uvec4 Passes::regionAround(const Crop& band) const {
  return regionOf(band, data_.constants[shared::SPEC_APRON], scene_.camera.width,
                  scene_.camera.height);
}

std::uint32_t Passes::mostOf(const Crop& band, std::uint32_t samples) const {
  return mapped() ? map_->most(cropOf(regionAround(band))) : samples;
}

std::uint32_t Passes::traceCentres(const Crop& band) {
  if (stops(options_.observers)) return 0;
  shared::Pass pass{};
  pass.region = pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
  pass.samples.y = 1;
  traced_ = {band};
  filmIsClear_ = false;
  tracePass(pass);
  return 1;
}

std::uint32_t Passes::add(const Crop& band, std::uint32_t first, std::uint32_t end,
                          const std::function<void(std::uint32_t)>& passed) {
  shared::Pass pass{};
  pass.region = regionAround(band);
  pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
  if (mapped())
    onDevice_.upload(map_->counts(pass.region));
  else
    planParts(pass);
  const std::uint64_t before = stats_.samples;
  std::uint32_t done = first;
  while (done < end && !stops(options_.observers)) {
    pass.samples.x = done;
    pass.samples.y = std::min(plan_.samplesAPass, end - done);
    tracePass(pass);
    gatherPass(pass);
    ++stats_.passes;
    done += pass.samples.y;
    stats_.samples =
        before + (mapped() ? map_->samplesOf(band, done)
                           : std::uint64_t{pass.core.z} * pass.core.w * (done - first));
    passed(done);
  }
  return done;
}

/// Only what sees something has sums, and only what those need is traced.
void Passes::planParts(const shared::Pass& pass) {
  const double each = kDispatchSamples / plan_.samplesAPass;
  // Strips begin with the rows above them that reach into theirs.
  gathered_ = gatherable_.parts(cropOf(pass.core), {each, 2.0 * apron()});
  Footprint needed(gatherable_.width(), gatherable_.height());
  for (const Crop& part : gathered_) needed.add(part);
  traced_ = needed.grown(apron()).parts(cropOf(pass.region), {each, 0});
}

void Passes::forgetDropped() {
  status_.dropped = 0;
  onDevice_.status().upload(std::as_bytes(std::span(&status_, 1)));
}

/// Traces the samples of a pass. Where a packet of rays meets more of the scene than one invocation
/// may walk through, this pass and all that follow go ray by ray: the same bits.
void Passes::tracePass(const shared::Pass& pass) {
  const shared::Status before = status_;
  if (mapped()) listWork(pass);
  dispatchPass(pass);
  if (status_.incomplete != 0 && stats_.traversal != "lane") {
    stats_.traversal = "lane";
    stats_.leftOut.emplace_back(
        fmt::format("packets: {} of them ran more loops than the driver lets one invocation run",
                    status_.incomplete / 8));
    compileTrace();
    onDevice_.status().upload(std::as_bytes(std::span(&before, 1)));
    dispatchPass(pass);
  }
  if (status_.incomplete != 0)
    throw Error(ExitCode::Device,
                fmt::format("{} rays were not traced to their end: the driver lets one "
                            "invocation run too few loop iterations",
                            status_.incomplete));
}

/// All lights in one dispatch, or a few in each of several.
void Passes::dispatchPass(shared::Pass pass) {
  const Stopwatch watch(stats_.seconds.trace);
  const bool lit = constants_[shared::SPEC_LIGHTS] != shared::LIGHTS_NONE;
  const auto lights = lit ? static_cast<std::uint32_t>(data_.lights.size()) : 0U;
  std::uint32_t first = 0;
  do {
    const std::uint32_t count = std::min(lights - first, shared::LIGHTS_A_DISPATCH);
    pass.lights = {first, count, first == 0 ? 1 : 0, first + count == lights ? 1 : 0};
    device_.run([&](VkCommandBuffer commands) { dispatchSamples(commands, pass); });
    first += count;
  } while (first < lights);
  onDevice_.status().download(std::as_writable_bytes(std::span(&status_, 1)));
}

/// As many samples of a pixel side by side as there are: 64, 16, 4 or 1 in a tile of 64.
void Passes::dispatchSamples(VkCommandBuffer commands, shared::Pass pass) const {
  pass.part = {0, 0, pass.region.z, pass.region.w};
  std::uint32_t done = 0;
  for (std::size_t i = 0; i < kShifts.size(); ++i) {
    const std::uint32_t shift = kShifts[i];
    if (mapped()) {
      pass.tiles.z = shift;
      dispatchListed(commands, *trace_, pass, tracing_[i]);
      continue;
    }
    const std::uint32_t count = (pass.samples.y - done) >> shift;
    if (count == 0 || 1U << shift > plan_.sideBySide) continue;
    const std::uint32_t side = 8U >> shift / 2;
    for (const Crop& part : traced_) {
      pass.part = within(part, pass.region);
      const std::uint32_t rows = groups(pass.part.w - pass.part.y, side);
      pass.tiles = {rows, rowStride(rows), shift, done};
      trace_->dispatch(commands, onDevice_.bindings(), bytes(pass),
                       {groups(pass.part.z - pass.part.x, side), rows, count});
    }
    done += count << shift;
  }
}

void Passes::gatherPass(shared::Pass pass) {
  const Stopwatch watch(stats_.seconds.reconstruct);
  pass.tiles = {mapped() ? shared::STRIP_ROWS : plan_.gatherRows, 0, 0, 0};
  device_.run([&](VkCommandBuffer commands) {
    if (mapped()) {
      pass.part = {0, 0, pass.core.z, pass.core.w};
      return dispatchListed(commands, *gather_, pass, gathering_);
    }
    for (const Crop& part : gathered_) {
      pass.part = within(part, pass.core);
      // Strips begin where blocks of slots do, or halfway: up to as many columns before the part.
      const std::uint32_t columns = pass.part.z - pass.part.x + pass.core.x - pass.region.x;
      gather_->dispatch(commands, onDevice_.bindings(), bytes(pass),
                        {groups(columns, shared::GATHER_GROUP),
                         groups(pass.part.w - pass.part.y, plan_.gatherRows), 1});
    }
  });
}

/// Lists the work of a pass where cells have counts of their own.
void Passes::listWork(const shared::Pass& pass) {
  std::vector<shared::Work> list;
  Footprint needed(gatherable_.width(), gatherable_.height());
  gathering_ =
      listGathering(*map_, pass, data_.constants[shared::SPEC_APRON], gatherable_, needed, list);
  for (std::size_t i = 0; i < kShifts.size(); ++i)
    tracing_[i] = listTracing(*map_, pass, kShifts[i], needed, list);
  onDevice_.upload(list);
}

void Passes::dispatchListed(VkCommandBuffer commands, const Kernel& kernel, shared::Pass pass,
                            const WorkRange& work) const {
  if (work.rows == 0) return;
  pass.tiles.w = work.first;
  kernel.dispatch(commands, onDevice_.bindings(), bytes(pass), {work.columns, work.rows, 1});
}

}  // namespace laver
