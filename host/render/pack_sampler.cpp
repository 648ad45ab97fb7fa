#include <algorithm>
#include <bit>

#include "render/pack_parts.h"

namespace laver {
namespace {

constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;
constexpr std::uint64_t kBlockPixels = std::uint64_t{32} * 32;
constexpr std::uint64_t kNumbersPerSample = 4;
/// Number of samples covered by the first of the two tables indexed by sample.
constexpr std::uint32_t kLowSamples = 1024;

/// The jump `a` followed by the jump `b`.
PcgJump then(PcgJump a, PcgJump b) {
  return {b.multiplier * a.multiplier, b.multiplier * a.increments + b.increments};
}

glm::uvec2 halves(std::uint64_t x) {
  return {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(x >> 32)};
}

/// Appends `count` jumps, by first, first + step, ... steps.
void appendTable(std::vector<shared::Jump>& table, std::uint64_t first, std::uint64_t step,
                 std::uint64_t count) {
  PcgJump jump = pcgJump(first);
  const PcgJump next = pcgJump(step);
  for (std::uint64_t i = 0; i < count; ++i) {
    table.push_back({halves(jump.multiplier), halves(jump.increments)});
    jump = then(jump, next);
  }
}

void packTables(std::uint32_t samples, std::uint32_t levels, Packed& packed) {
  // Indexed by the pixel of the block, including the step that ends the seeding of PCG32.
  appendTable(packed.jumps, 1, kNumbersPerSample * samples, kBlockPixels);
  const std::uint32_t low = std::min(samples, kLowSamples);
  packed.params.samplerArguments = {static_cast<std::uint32_t>(packed.jumps.size()), 0, low, 0};
  appendTable(packed.jumps, 0, kNumbersPerSample, low);
  if (levels >= 3) {
    packed.params.samplerArguments.y = static_cast<std::uint32_t>(packed.jumps.size());
    appendTable(packed.jumps, 0, kNumbersPerSample * low, (samples - 1) / low + 1);
  }
}

/// Half a step of the finest grid whose points plus half a step are exact in float on the whole
/// film, in 2^-32 pixels; unitFloat() has 23 bits.
std::uint32_t halfStep(const Camera& camera) {
  const auto last = static_cast<std::uint32_t>(std::max(camera.width, camera.height) - 1);
  const int bits = std::clamp(24 - static_cast<int>(std::bit_width(last)), 1, 23);
  return 1U << (32 - bits);
}

}  // namespace

PcgJump pcgJump(std::uint64_t steps) {
  PcgJump result, power{kMultiplier, 1};
  for (; steps != 0; steps >>= 1) {
    if ((steps & 1U) != 0) result = then(result, power);
    power = then(power, power);
  }
  return result;
}

std::uint32_t jumpLevels(std::uint32_t samples) { return samples <= kLowSamples ? 2 : 3; }

void packSampler(const Scene& scene, std::uint32_t jumpLevels, Packed& packed) {
  const Sampler& sampler = scene.sampler;
  packed.params.sampleCount = sampler.sampleCount;
  packSeed(sampler.seed, packed.params);
  packed.params.halfStep = halfStep(scene.camera);
  if (sampler.row->stream) packTables(sampler.sampleCount, jumpLevels, packed);
  if (sampler.row->strata) {
    const glm::uvec2 strata = strataOf(sampler.sampleCount);
    const auto size = [](std::uint32_t count) {
      return static_cast<std::uint32_t>((std::uint64_t{1} << 32) / count);
    };
    packed.params.samplerArguments = {strata.y, size(strata.x), size(strata.y), 0};
  }
}

void packSeed(std::int64_t seed, shared::Params& params) {
  const glm::uvec2 parts = halves(static_cast<std::uint64_t>(seed));
  params.seed = parts;
  params.seedHash = parts.x ^ parts.y * 0x9e3779b9U;
}

}  // namespace laver
