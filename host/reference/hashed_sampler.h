#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace laver::reference {

/// Film position, in pixels, of a sample of `stratified` or `sobol`, whose randomness is a hash of
/// the pixel and the seed. It is the middle of a cell of a grid so fine that it is a float's.
///
/// `stratified`: strata of one size, column by column, from a stratum that the pixel's hash picks;
/// in each a hash of the pixel and the sample's number.
/// `sobol`: Sobol's first two dimensions, each Owen-scrambled by its own seed.
glm::vec2 hashedPosition(const Camera& camera, const Sampler& sampler, int x, int y,
                         std::uint32_t sample);

/// Two numbers in [0, 1) that have nothing to do with that place. `sobol`: its sequence in an order
/// that Owen scrambling of the sample's number gives. `stratified`: at random.
glm::vec2 hashedAperture(const Sampler& sampler, int x, int y, std::uint32_t sample);

}  // namespace laver::reference
