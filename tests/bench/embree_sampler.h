#pragma once
#include <cstdint>

#include "shared/layout.h"

namespace laver::bench {

/// Sixteen samples: their pixels and numbers, and where they lie in their pixels, in 2^-32.
struct Places {
  alignas(64) std::uint32_t pixelX[16], pixelY[16], number[16];
  alignas(64) std::uint32_t x[16], y[16];
};

/// As shaders/sampler_hashed.glsl places them, in loops that the compiler turns into vectors; of
/// parameters that packSampler() filled for the sampler.
void placeSobol(const shared::Params& params, Places& places);
void placeStratified(const shared::Params& params, Places& places);

}  // namespace laver::bench
