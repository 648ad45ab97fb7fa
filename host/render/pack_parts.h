#pragma once
#include "render/packed.h"

// The parts of pack(). Each fills what its name says of `packed`.
namespace laver {

/// The camera's parameters; packed.space must be there.
void packCamera(const Camera& camera, Packed& packed);

/// The filter's parameters; the table is Nori's or that of filter/gaussian_narrow.glsl.
void packFilter(const Filter& filter, bool noriTable, shared::Params& params);

/// The sampler's parameters and tables, of `jumpLevels` levels.
void packSampler(const Scene& scene, std::uint32_t jumpLevels, Packed& packed);
/// The seed alone.
void packSeed(std::int64_t seed, shared::Params& params);

/// The integrator's float properties, in the order of its row. Lengths come to normalised space,
/// whose points lie less than 4 apart; below 2^-100 nothing is seen apart.
glm::vec4 propertiesOf(const IntegratorUse& integrator, const Normalisation& space);

/// What meshes emit, and the light sources of light sampling; tree, space and lights must be there.
void packSources(const Scene& scene, Packed& packed);

/// n steps of PCG32: state(n) = multiplier * state(0) + increments * inc (Brown, "Random Number
/// Generation with Arbitrary Strides", 1994).
struct PcgJump {
  std::uint64_t multiplier = 1, increments = 0;
};
PcgJump pcgJump(std::uint64_t steps);

/// Levels of tables that `independent` needs for that many samples per pixel: 1 to 3.
std::uint32_t jumpLevels(std::uint32_t samples);

}  // namespace laver
