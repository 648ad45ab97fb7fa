#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "reference/sampler.h"

/// Random numbers that are hashes of the pixel, the sampler's seed, the sample and the dimension.
namespace laver::reference::hashed {

using Word = std::uint32_t;
using Hash = std::array<Word, 3>;

/// Between the seeds of two dimensions: 2^32 over the golden ratio.
inline constexpr Word kDimensionStep = 0x9e3779b9u;

/// pcg3d of Jarzynski and Olano, JCGT 9(3), 2020, and its step of shifts once more.
Hash hashOf(Word a, Word b, Word c);

/// The 64 bits of the seed in 32.
Word foldedSeed(const Sampler& sampler);

Hash pixelHash(const PixelSample& at, Word seed);

/// Coordinates in a pixel, in 2^-32.
struct Place {
  Word x, y;
};

/// The middle of the cell of a place in a grid over the pixel, so fine that the sum with the
/// pixel's number is a float's.
glm::vec2 filmPosition(const Camera& camera, const PixelSample& at, const Place& place);

/// In [0, 1), of 23 bits.
glm::vec2 unitPair(const Place& place);

/// Uniform, each by itself.
glm::vec2 randomPair(const Sampler& sampler, const PixelSample& at, std::uint32_t dimension);

}  // namespace laver::reference::hashed
