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

/// Fills data.jumps and the sampler's part of data.params and data.constants.
void packSampler(const Scene& scene, bool generic, SceneData& data);

}  // namespace laver
