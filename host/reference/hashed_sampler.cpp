#include "reference/hashed_sampler.h"

#include <algorithm>
#include <cmath>

namespace laver::reference::hashed {

Hash hashOf(Word a, Word b, Word c) {
  Hash v{a, b, c};
  for (Word& w : v) w = w * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < 3; ++i) v[i] += v[(i + 1) % 3] * v[(i + 2) % 3];
    for (Word& w : v) w ^= w >> 16;
  }
  return v;
}

Word foldedSeed(const Sampler& sampler) {
  const auto seed = static_cast<std::uint64_t>(sampler.seed);
  return static_cast<Word>(seed) ^ static_cast<Word>(seed >> 32) * 0x9e3779b9u;
}

Hash pixelHash(const PixelSample& at, Word seed) {
  return hashOf(static_cast<Word>(at.x), static_cast<Word>(at.y), seed);
}

glm::vec2 filmPosition(const Camera& camera, const PixelSample& at, const Place& place) {
  // A float has 24 bits. The bits that the largest pixel number leaves, at most 23, represent the
  // centre of a cell, and all but the last of them the cell.
  int bits = 24;
  for (int largest = std::max(camera.width, camera.height) - 1; largest != 0; largest /= 2) --bits;
  bits = std::clamp(bits, 1, 23);
  const auto centre = [&](Word position) {
    const double cells = std::ldexp(1.0, bits - 1);
    return (std::floor(position * std::ldexp(1.0, -32) * cells) + 0.5) / cells;
  };
  return {static_cast<float>(at.x + centre(place.x)), static_cast<float>(at.y + centre(place.y))};
}

glm::vec2 unitPair(const Place& place) {
  const auto number = [](Word w) { return std::ldexp(static_cast<float>(w >> 9), -23); };
  return {number(place.x), number(place.y)};
}

glm::vec2 randomPair(const Sampler& sampler, const PixelSample& at, std::uint32_t dimension) {
  const Hash pixel = pixelHash(at, foldedSeed(sampler) ^ (dimension * kDimensionStep));
  const Hash random = hashOf(pixel[0], pixel[1], at.sample);
  return unitPair({random[0], random[1]});
}

}  // namespace laver::reference::hashed
