// Renders that do not fit a device are split, or refused with the name of the limit and both
// numbers.
#include <gtest/gtest.h>

#include "pictures/harness.h"
#include "render/tiling.h"
#include "stability/record.h"

namespace laver::test {
namespace {

VkPhysicalDeviceLimits small() {
  VkPhysicalDeviceLimits limits{};
  limits.maxStorageBufferRange = 1U << 27;
  limits.maxTexelBufferElements = 1U << 27;
  limits.maxComputeWorkGroupCount[0] = limits.maxComputeWorkGroupCount[1] =
      limits.maxComputeWorkGroupCount[2] = 65535;
  return limits;
}

LAVER_STABILITY(Limits, "Buffer limits") {
  std::uint64_t plans = 0, naive = 0, beyond = 0, refused = 0, unnamed = 0;
  for (const std::uint32_t range : {1U << 12, 1U << 16, 1U << 20, 1U << 27})
    for (const std::uint32_t texels : {1U << 10, 1U << 16, 1U << 27})
      for (const int width : {1, 100, 4096, 100000, 1000000})
        for (const std::uint32_t samples : {1U, 64U, 65536U})
          for (const std::uint32_t apron : {1U, 2U, 9U}) {
            VkPhysicalDeviceLimits limits = small();
            limits.maxStorageBufferRange = range;
            limits.maxTexelBufferElements = texels;
            ++plans;
            // Naive: all samples of the film in one buffer.
            const double all = 100.0 * width * samples * kSampleBytes;
            naive += all > range ? 1 : 0;
            try {
              const Tiling plan = tile(limits, {{0, 0, width, 100}, width, 100, apron, samples});
              beyond += plan.sampleSlots * kSampleBytes > range || plan.sampleSlots > texels ||
                                plan.bandPixels * sizeof(shared::FilmPixel) > range
                            ? 1
                            : 0;
            } catch (const Error& error) {
              ++refused;
              const std::string text = error.what();
              unnamed += text.find("max") == std::string::npos &&
                                 text.find("loop iterations") == std::string::npos
                             ? 1
                             : 0;
            }
          }
  EXPECT_GT(refused, 0U);
  EXPECT_LT(refused, plans);
  record.add({"plans beyond a limit", "plan", plans, static_cast<double>(naive),
              static_cast<double>(beyond), 0.0, "plans"});
  record.add({"refusals that name no limit", "plan", refused, std::nullopt,
              static_cast<double>(unnamed), 0.0, "refusals"});
}

}  // namespace
}  // namespace laver::test
