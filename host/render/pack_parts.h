#pragma once
#include <array>
#include <vector>

#include "render/packed.h"

// The parts of pack(). Each fills the members of `packed` that its name states.
namespace laver {

/// The camera's parameters; requires packed.space.
void packCamera(const Camera& camera, Packed& packed);

/// The filter's parameters. The table is Nori's if `noriTable`, else that of
/// filter/gaussian_narrow.glsl.
void packFilter(const Filter& filter, bool noriTable, shared::Params& params);

/// The sampler's parameters and its jump tables of `jumpLevels` levels.
void packSampler(const Scene& scene, std::uint32_t jumpLevels, Packed& packed);
/// Only the seed.
void packSeed(std::int64_t seed, shared::Params& params);

/// The integrator's properties, in the order of its row: a number is one component, a triple three.
/// Points and lengths are converted to normalised space, and lengths clamped to [2^-100, reach].
std::array<glm::vec4, 2> propertiesOf(const IntegratorUse& integrator, const Packed& packed);

shared::Light packedLight(const PointLight& light, const Normalisation& space);
/// Flux of a light in the scene's units; of a directional one through a disk of this radius.
double powerOf(const PointLight& light, double radius);

/// What meshes emit, and the light sources of light sampling; tree, space and lights must be there.
void packSources(const Scene& scene, Packed& packed);

/// Attributes in the order of the leaves, from attributes in file order.
std::vector<shared::Attributes> inLeafOrder(const std::vector<shared::Attributes>& attributes,
                                            const std::vector<shared::Triangle>& inFileOrder,
                                            const Bvh& bvh);
/// Packs four numbers per triangle, or only its material if no kernel reads normals.
void packAttributes(const std::vector<shared::Attributes>& attributes, const Uploads& uploads,
                    Packed& packed);

/// n steps of PCG32: state(n) = multiplier * state(0) + increments * inc (Brown, "Random Number
/// Generation with Arbitrary Strides", 1994).
struct PcgJump {
  std::uint64_t multiplier = 1, increments = 0;
};
PcgJump pcgJump(std::uint64_t steps);

/// Number of table levels that `independent` needs for `samples` samples per pixel: 1 to 3.
std::uint32_t jumpLevels(std::uint32_t samples);

}  // namespace laver
