#include "render/tiling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"

namespace laver {

namespace {

/// Loop iterations of film/gather.glsl per sample index, including its outer loops.
std::uint64_t gatherIterations(std::uint64_t rows, std::uint64_t apron) {
  return (rows + 2 * apron) * (2 * apron + 1 + 2);
}

/// Longer columns share more reads, shorter ones give more invocations; long ones suit CPUs.
constexpr std::uint32_t kGatherRows = 64;

std::uint64_t roundedUp(std::uint64_t n, std::uint64_t unit) {
  return (n + unit - 1) / unit * unit;
}

}  // namespace

std::uint32_t rowStride(std::uint32_t rows) {
  auto stride = std::max(1U, static_cast<std::uint32_t>(0.618 * rows));
  while (std::gcd(stride, rows) != 1) ++stride;
  return stride;
}

glm::uvec4 regionOf(Crop core, std::uint32_t apron, int width, int height) {
  const int a = static_cast<int>(apron);
  const int x0 = std::max(core.x0 - a, 0), x1 = std::min(core.x1 + a, width);
  const int y0 = std::max(core.y0 - a, 0), y1 = std::min(core.y1 + a, height);
  return {x0, y0, x1 - x0, y1 - y0};
}

Tiling tile(const VkPhysicalDeviceLimits& limits, const TilingNeeds& needs) {
  const auto& [core, width, height, apron, samples, maxSlots, sideBySide] = needs;
  // 2^22 samples take 84 MB and fill a GPU; a dispatch of as many rays ends well before a
  // watchdog's time limit.
  std::uint64_t slots = maxSlots == 0 ? std::uint64_t{1} << 22 : maxSlots;
  slots = std::min(slots, limits.maxStorageBufferRange / kSampleBytes);
  slots = std::min<std::uint64_t>(slots, limits.maxTexelBufferElements - kMaxTexelsAdded);
  const std::uint64_t filmRows = limits.maxStorageBufferRange / sizeof(shared::FilmPixel) /
                                 static_cast<std::uint64_t>(core.x1 - core.x0);

  const glm::uvec4 full = regionOf(core, apron, width, height);
  const std::uint64_t a = apron, slotsPerRow = roundedUp(full.z, shared::SLOT_COLUMNS);
  const std::uint64_t unit = std::min(samples, shared::GATHER_SAMPLES);
  const std::uint64_t minRows = std::min<std::uint64_t>(2 * a + 1, full.w);
  const std::uint64_t smallest = slotsPerRow * minRows * unit;
  if (smallest > slots && maxSlots == 0)
    throw Error(ExitCode::Device,
                fmt::format("one row of {} pixels with its filter apron needs {} samples in "
                            "flight; the device's maxStorageBufferRange and "
                            "maxTexelBufferElements allow {}",
                            full.z, smallest, slots));
  slots = std::max(slots, smallest);

  std::uint32_t gatherRows = kGatherRows;
  while (gatherRows > 1 && gatherIterations(gatherRows, a) * unit > shared::MAX_ITERATIONS)
    gatherRows /= 2;
  const std::uint64_t iterations = gatherIterations(gatherRows, a);
  if (iterations * unit > shared::MAX_ITERATIONS)
    throw Error(ExitCode::Device,
                fmt::format("the filter reaches {} pixels to each side; gathering takes {} loop "
                            "iterations, one invocation may run {}",
                            apron, iterations * unit, shared::MAX_ITERATIONS));
  const std::uint64_t maxPass =
      std::min({std::uint64_t{shared::MAX_ITERATIONS} / iterations, std::uint64_t{samples},
                std::uint64_t{limits.maxComputeWorkGroupCount[2]}});

  // Prefers fewer rows to fewer samples side by side, but at least four times the overlapping rows.
  const auto coreRows = static_cast<std::uint64_t>(core.y1 - core.y0);
  const std::uint64_t wanted = std::min<std::uint64_t>(maxPass, sideBySide);
  std::uint64_t rows = std::max(
      {slots / slotsPerRow / wanted, std::min(8 * a, slots / slotsPerRow / unit), minRows});
  rows = full.w <= rows ? coreRows : std::max<std::uint64_t>(rows, 2 * a + 1) - 2 * a;
  rows = std::max<std::uint64_t>(
      1, std::min({rows, coreRows, filmRows, std::uint64_t{limits.maxComputeWorkGroupCount[1]}}));
  const std::uint64_t regionRows = std::min<std::uint64_t>(rows + 2 * a, full.w);
  std::uint64_t pass = std::min(slots / (slotsPerRow * regionRows), maxPass);
  if (pass != samples) pass = std::max(pass / unit * unit, unit);
  // Strips of equal length, since lavapipe gives each thread the same number.
  const std::uint64_t strips = (rows + gatherRows - 1) / gatherRows;
  gatherRows = static_cast<std::uint32_t>((rows + strips - 1) / strips);
  return {core,
          static_cast<std::uint32_t>(rows),
          static_cast<std::uint32_t>(pass),
          slotsPerRow * regionRows * roundedUp(pass, unit),
          static_cast<std::uint64_t>(core.x1 - core.x0) * rows,
          gatherRows,
          sideBySide};
}

std::uint32_t bandsOf(const std::vector<Strip>& strips, const Tiling& tiling) {
  std::uint32_t bands = 0;
  for (const Strip& strip : strips)
    bands += groupsOf(static_cast<std::uint32_t>(strip.rows()), tiling.bandRows);
  return bands;
}

std::uint32_t passesOf(std::uint32_t samples, const Tiling& tiling) {
  return (samples + tiling.samplesPerPass - 1) / tiling.samplesPerPass;
}

std::uint32_t samplesSideBySide(const Tiling& tiling, bool adaptive) {
  const std::uint32_t room =
      std::min({tiling.samplesPerPass, tiling.sideBySide, adaptive ? 16U : 64U});
  return room >= 64 ? 64 : room >= 16 ? 16 : room >= 4 ? 4 : 1;
}

std::uint32_t apronOf(double radius) {
  return static_cast<std::uint32_t>(std::floor(radius + 0.5));
}

}  // namespace laver
