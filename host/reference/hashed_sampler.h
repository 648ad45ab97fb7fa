#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "reference/sampler.h"

/// Random numbers as hashes of the pixel, the sampler's seed, the sample and the dimension.
namespace laver::reference::hashed {

using Word = std::uint32_t;
using Hash = std::array<Word, 3>;

/// Difference between the seeds of successive dimensions: 2^32 over the golden ratio.
inline constexpr Word kDimensionStep = 0x9e3779b9u;

/// pcg3d of Jarzynski and Olano, JCGT 9(3), 2020, with its shifts applied a second time.
Hash hashOf(Word a, Word b, Word c);

/// The 64 bits of the seed, folded to 32.
Word foldedSeed(const Sampler& sampler);

Hash pixelHash(const PixelSample& at, Word seed);

/// A position inside a pixel, in units of 2^-32.
struct Place {
  Word x, y;
};

/// The position of `place` on the film, rounded to the centre of its cell of a grid whose sums with
/// pixel numbers are exact in float.
glm::vec2 filmPosition(const Camera& camera, const PixelSample& at, const Place& place);

/// Two floats in [0, 1) of 23 bits.
glm::vec2 unitPair(const Place& place);

/// Two independent uniform numbers.
glm::vec2 randomPair(const Sampler& sampler, const PixelSample& at, std::uint32_t dimension);

}  // namespace laver::reference::hashed
