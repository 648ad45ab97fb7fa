#pragma once
#include <cstdint>

#include "render/scene_data.h"

namespace laver {

/// state(n) = multiplier * state(0) + increments * inc (mod 2^64) of PCG32's generator.
struct PcgJump {
  std::uint64_t multiplier = 1;
  std::uint64_t increments = 0;
};

/// The jump by `steps` (Brown, "Random Number Generation with Arbitrary Strides", 1994).
PcgJump pcgJump(std::uint64_t steps);

/// Tables that so many samples a pixel of `independent` need: SPEC_JUMP_LEVELS.
std::uint32_t jumpLevels(std::uint32_t samples);

/// Fills data.jumps, where the sampler reads them, and the sampler's part of data.params, as
/// data.constants say.
void packSampler(const Scene& scene, SceneData& data);

/// The part of the parameters that a seed decides.
void packSeed(std::int64_t seed, shared::Params& params);

}  // namespace laver
