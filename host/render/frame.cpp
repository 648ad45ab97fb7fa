#include "render/frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/compose.h"
#include "render/pack_parts.h"
#include "render/scene_coverage.h"
#include "render/stopwatch.h"

namespace laver {
namespace {

/// Fixed cost of a dispatch, in samples.
constexpr double kDispatchSamples = 1000;

/// Of a dispatch: every device supports rows of 65,535 workgroups, which may be one pixel wide.
constexpr std::uint32_t kMostColumns = 65528;

/// First and end column and row of a part, relative to the area's corner.
glm::uvec4 within(const Crop& part, const glm::uvec4& area) {
  const glm::uvec4 edges(part.x0, part.y0, part.x1, part.y1);
  return edges - glm::uvec4(area.x, area.y, area.x, area.y);
}

/// Uploads the scene and clears the film, while kernels may be compiling.
DeviceScene uploaded(const Device& device, const Packed& packed, const Choices& choices,
                     double& seconds) {
  const Stopwatch watch(seconds);
  DeviceScene scene(device, packed, choices.tiling, choices.gather.storageTexels);
  scene.film().fillZero();
  return scene;
}

}  // namespace

Frame::Frame(const Device& device, const Packed& packed, const Choices& choices,
             std::future<Kernels> kernels)
    : device_(device),
      packed_(packed),
      choices_(choices),
      onDevice_(uploaded(device, packed, choices, work_.uploadSeconds)),
      traversal_(choices.traversal),
      covered_(coverageOf(packed)),
      kernels_(kernels.get()),
      gatherable_(covered_) {
  work_.modules = {kernels_.trace->source, kernels_.gather->source};
}

void Frame::begin(const PictureChoice& picture) {
  const bool first = &picture == &choices_.pictures.front();
  const bool deeper = stackFor(picture.key.stack, packed_.bvh.stack) != picture.key.stack;
  picture_ = &picture;
  if (work_.fallback.empty()) traversal_ = picture.key.traversal;
  gatherable_ = picture.blackMiss ? covered_.grown(apron())
                                  : Coverage::whole(covered_.width(), covered_.height());
  onDevice_.upload(paramsOf(picture.integrator));
  if (!first || deeper) compileTrace(traversal_);
}

shared::Params Frame::paramsOf(const IntegratorUse& integrator) const {
  shared::Params params = packed_.params;
  const auto properties = propertiesOf(integrator, packed_);
  std::copy(properties.begin(), properties.end(), params.properties);
  return params;
}

void Frame::seed(std::int64_t seed) const {
  shared::Params params = paramsOf(picture_->integrator);
  packSeed(seed, params);
  onDevice_.upload(params);
}

void Frame::compileTrace(Traversal traversal) {
  const Stopwatch watch(work_.compileSeconds);
  TraceKey key = picture_->key;
  key.traversal = traversal;
  key.portions = portions_.has_value();
  key.stack = stackFor(key.stack, key.portions ? portions_->stack : packed_.bvh.stack);
  kernels_.trace = compileKernel(device_, onDevice_.bindings(), compose(key));
  work_.modules.push_back(kernels_.trace->source);
}

void Frame::clearFilm() {
  if (!filmIsClear_) onDevice_.film().fillZero();
  filmIsClear_ = false;
}

void Frame::setFilm(std::span<const std::byte> sums) {
  onDevice_.film().upload(sums);
  filmIsClear_ = false;
}

std::span<const std::byte> Frame::filmOf(const Crop& band) {
  const std::size_t pixels =
      static_cast<std::size_t>(band.x1 - band.x0) * static_cast<std::size_t>(band.y1 - band.y0);
  return onDevice_.film().contents(pixels * sizeof(shared::FilmPixel), copy_);
}

glm::uvec4 Frame::regionAround(const Crop& band) const {
  return regionOf(band, choices_.gather.apron, covered_.width(), covered_.height());
}

std::uint32_t Frame::maxSamples(const Crop& band, std::uint32_t samples) const {
  return mapped() ? map_->max(cropOf(regionAround(band))) : samples;
}

shared::Pass Frame::passOverCentres(const Crop& band) {
  shared::Pass pass{};
  pass.region = pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
  pass.sampleCount = 1;
  traced_ = {band};
  filmIsClear_ = false;
  return pass;
}

shared::Pass Frame::passOver(const Crop& band) {
  shared::Pass pass{};
  pass.region = regionAround(band);
  pass.core = {band.x0, band.y0, band.x1 - band.x0, band.y1 - band.y0};
  if (mapped())
    onDevice_.upload(map_->counts(pass.region));
  else
    planParts(pass);
  return pass;
}

/// Splits the pass into rectangles: only covered pixels are gathered, and only the samples that
/// these need are traced.
void Frame::planParts(const shared::Pass& pass) {
  const double each = kDispatchSamples / choices_.tiling.samplesPerPass;
  // Each strip also reads the rows above and below that reach into it.
  gathered_ = gatherable_.parts(cropOf(pass.core), {each, 2.0 * apron()});
  Coverage needed(gatherable_.width(), gatherable_.height());
  for (const Crop& part : gathered_) needed.add(part);
  traced_ = needed.grown(apron()).parts(cropOf(pass.region), {each, 0});
}

void Frame::forgetDropped() {
  status_.dropped = 0;
  onDevice_.status().upload(std::as_bytes(std::span(&status_, 1)));
}

/// If loops were cut short, this pass is traced again, and all later ones are traced, in smaller
/// steps. The bits are the same.
void Frame::trace(const shared::Pass& pass) {
  const shared::Status before = status_;
  if (mapped()) listWork(pass);
  dispatchLights(pass);
  while (status_.incomplete != 0 && takesSmallerSteps()) {
    status_ = before;
    onDevice_.status().upload(std::as_bytes(std::span(&status_, 1)));
    dispatchLights(pass);
  }
  if (status_.incomplete != 0)
    throw Error(ExitCode::Device,
                fmt::format("{} rays were not traced to their end: the driver lets one "
                            "invocation run too few loop iterations",
                            status_.incomplete));
}

/// Dispatches a pass once, or several times if there are many lights.
void Frame::dispatchLights(shared::Pass pass) {
  const Stopwatch watch(work_.traceSeconds);
  // Light sampling draws one light; other integrators sum them all.
  const bool sums = picture_->key.lights && !picture_->integrator.row->needs.emitters;
  const auto lights = sums ? static_cast<std::uint32_t>(packed_.lights.size()) : 0U;
  pass.firstLight = 0;
  do {
    pass.lightCount = std::min(lights - pass.firstLight, shared::LIGHTS_PER_DISPATCH);
    pass.firstDispatch = pass.firstLight == 0 ? 1 : 0;
    pass.lastDispatch = pass.firstLight + pass.lightCount == lights ? 1 : 0;
    if (portions_) {
      dispatchPortions(pass);
    } else {
      const std::vector<Dispatch> dispatches = tracing(pass);
      device_.run([&](VkCommandBuffer commands) {
        for (const Dispatch& dispatch : dispatches)
          record(commands, kernels_.trace->kernel, dispatch);
      });
    }
    pass.firstLight += pass.lightCount;
  } while (pass.firstLight < lights);
  onDevice_.status().download(std::as_writable_bytes(std::span(&status_, 1)));
}

/// Decreasing numbers of samples side by side: 64, 16, 4 or 1 per pixel in a tile of 64.
std::vector<Frame::Dispatch> Frame::tracing(shared::Pass pass) const {
  std::vector<Dispatch> dispatches;
  pass.part = {0, 0, pass.region.z, pass.region.w};
  pass.dispatchSample = 0;
  for (std::size_t i = 0; i < kShifts.size(); ++i) {
    pass.sideShift = kShifts[i];
    if (mapped()) {
      if (tracing_[i].rows != 0) dispatches.push_back(listed(pass, tracing_[i]));
      continue;
    }
    const std::uint32_t count = (pass.sampleCount - pass.dispatchSample) >> pass.sideShift;
    if (count == 0 || 1U << pass.sideShift > choices_.tiling.sideBySide) continue;
    const std::uint32_t side = 8U >> pass.sideShift / 2;
    for (const Crop& part : traced_) {
      const glm::uvec4 whole = within(part, pass.region);
      for (std::uint32_t x = whole.x; x < whole.z; x += kMostColumns) {
        pass.part = {x, whole.y, std::min(x + kMostColumns, whole.z), whole.w};
        pass.tileRows = groupsOf(pass.part.w - pass.part.y, side);
        pass.rowStride = rowStride(pass.tileRows);
        dispatches.push_back(
            {pass, {groupsOf(pass.part.z - pass.part.x, side), pass.tileRows, count}});
      }
    }
    pass.dispatchSample += count << pass.sideShift;
  }
  return dispatches;
}

void Frame::record(VkCommandBuffer commands, const Kernel& kernel, const Dispatch& dispatch) const {
  kernel.dispatch(commands, onDevice_.bindings(), std::as_bytes(std::span(&dispatch.pass, 1)),
                  dispatch.groups);
}

Frame::Traced Frame::traced() {
  const auto all = [](const Buffer& buffer, std::vector<std::byte>& copy) {
    return buffer.contents(buffer.bytes(), copy);
  };
  const auto values = all(onDevice_.samples(), copyOfSamples_);
  const auto inY = all(onDevice_.samplesY(), copyOfY_);
  return {{reinterpret_cast<const glm::vec4*>(values.data()), values.size() / sizeof(glm::vec4)},
          {reinterpret_cast<const float*>(inY.data()), inY.size() / sizeof(float)},
          gathered_};
}

void Frame::gather(const shared::Pass& given) {
  const Stopwatch watch(work_.gatherSeconds);
  ++work_.passes;
  shared::Pass pass = given;
  pass.stripRows = mapped() ? shared::STRIP_ROWS : choices_.tiling.gatherRows;
  device_.run([&](VkCommandBuffer commands) {
    const Kernel& kernel = kernels_.gather->kernel;
    if (mapped()) {
      pass.part = {0, 0, pass.core.z, pass.core.w};
      if (gathering_.rows != 0) record(commands, kernel, listed(pass, gathering_));
      return;
    }
    for (const Crop& part : gathered_) {
      pass.part = within(part, pass.core);
      // Strips begin at blocks of slots, or halfway, and thus some columns before the part.
      const std::uint32_t columns = pass.part.z - pass.part.x + pass.core.x - pass.region.x;
      record(commands, kernel,
             {pass,
              {groupsOf(columns, shared::GATHER_GROUP),
               groupsOf(pass.part.w - pass.part.y, pass.stripRows), 1}});
    }
  });
}

/// Lists the work of a pass with sample counts by cell.
void Frame::listWork(const shared::Pass& pass) {
  std::vector<shared::Work> list;
  Coverage needed(gatherable_.width(), gatherable_.height());
  gathering_ = listGathering(*map_, pass, choices_.gather.apron, gatherable_, needed, list);
  for (std::size_t i = 0; i < kShifts.size(); ++i)
    tracing_[i] = listTracing(*map_, pass, kShifts[i], needed, list);
  onDevice_.upload(list);
}

Frame::Dispatch Frame::listed(shared::Pass pass, const WorkRange& work) {
  pass.firstWork = work.first;
  return {pass, {work.columns, work.rows, 1}};
}

}  // namespace laver
