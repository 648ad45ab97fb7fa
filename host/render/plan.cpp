#include "render/plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace laver {

glm::uvec4 regionOf(Crop core, std::uint32_t apron, int width, int height) {
  const int a = static_cast<int>(apron);
  const int x0 = std::max(core.x0 - a, 0), x1 = std::min(core.x1 + a, width);
  const int y0 = std::max(core.y0 - a, 0), y1 = std::min(core.y1 + a, height);
  return {x0, y0, x1 - x0, y1 - y0};
}

RenderPlan planRender(const VkPhysicalDeviceLimits& limits, Crop core, int width, int height,
                      std::uint32_t apron, std::uint32_t samples, std::uint64_t maxSlots) {
  // 2^21 samples take 117 MB with the default filter and fill a GPU; a dispatch of as many rays
  // ends well within a watchdog's seconds.
  std::uint64_t slots = maxSlots == 0 ? std::uint64_t{1} << 21 : maxSlots;
  slots =
      std::min(slots, limits.maxStorageBufferRange / std::max(kRadianceBytes, weightBytes(apron)));
  slots = std::min<std::uint64_t>(slots, limits.maxTexelBufferElements / (2 * (2 * apron + 1)));
  const std::uint64_t filmRows = limits.maxStorageBufferRange / sizeof(shared::FilmPixel) /
                                 static_cast<std::uint64_t>(core.x1 - core.x0);

  const glm::uvec4 full = regionOf(core, apron, width, height);
  const std::uint64_t a = apron;
  const std::uint64_t smallest = full.z * std::min<std::uint64_t>(2 * a + 1, full.w);
  if (smallest > slots && maxSlots == 0)
    throw Error(ExitCode::Device,
                fmt::format("one row of {} pixels with its filter apron needs {} samples in "
                            "flight; the device's maxStorageBufferRange and "
                            "maxTexelBufferElements allow {}",
                            full.z, smallest, slots));
  slots = std::max(slots, smallest);
  const auto coreRows = static_cast<std::uint64_t>(core.y1 - core.y0);
  std::uint64_t rows = slots / full.z;
  rows = full.w <= rows ? coreRows : std::max<std::uint64_t>(rows, 2 * a + 1) - 2 * a;
  rows = std::max<std::uint64_t>(
      1, std::min({rows, coreRows, filmRows, std::uint64_t{limits.maxComputeWorkGroupCount[1]}}));

  // Iterations of gather.comp for one sample index, its loops' own turns included.
  const std::uint64_t side = 2 * a + 1;
  const std::uint64_t turns = side * (side + 1) + 1;
  if (turns > shared::MAX_ITERATIONS)
    throw Error(ExitCode::Device,
                fmt::format("the filter reaches {} pixels to each side; gathering takes {} loop "
                            "iterations a sample, one invocation may run {}",
                            apron, turns, shared::MAX_ITERATIONS));
  const std::uint64_t regionRows = std::min<std::uint64_t>(rows + 2 * a, full.w);
  const std::uint64_t pass =
      std::min({std::max<std::uint64_t>(slots / (full.z * regionRows), 1),
                std::uint64_t{shared::MAX_ITERATIONS} / turns, std::uint64_t{samples},
                std::uint64_t{limits.maxComputeWorkGroupCount[2]}});
  Device::requireLimit("maxComputeWorkGroupCount[0]", (full.z + 7) / 8,
                       limits.maxComputeWorkGroupCount[0]);
  return {core, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(pass),
          full.z * regionRows * pass, static_cast<std::uint64_t>(core.x1 - core.x0) * rows};
}

}  // namespace laver
