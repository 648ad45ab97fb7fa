#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace laver::reference {

/// Film position, in pixels, of sample `sample` of pixel (x, y).
///
/// `independent`: every 32x32 block of the full film (cut at the border) has a PCG32 of its own,
/// with state block x + seed and sequence block y + seed, and uses four numbers a sample: y, x and
/// two for the aperture. The sum pixel + number is a float's. The others: hashed_sampler.h.
glm::vec2 samplePosition(const Camera& camera, const Sampler& sampler, int x, int y,
                         std::uint32_t sample);

/// The two numbers in [0, 1) for the aperture, drawn y first too. With a pinhole they are left for
/// integrators that choose a direction.
glm::vec2 sampleAperture(const Camera& camera, const Sampler& sampler, int x, int y,
                         std::uint32_t sample);

}  // namespace laver::reference
