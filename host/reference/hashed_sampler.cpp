#include "reference/hashed_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace laver::reference {

namespace {

using Word = std::uint32_t;
using Hash = std::array<Word, 3>;

// pcg3d of Jarzynski and Olano, JCGT 9(3), 2020, and its step of shifts once more.
Hash hashOf(Word a, Word b, Word c) {
  Hash v{a, b, c};
  for (Word& w : v) w = w * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < 3; ++i) v[i] += v[(i + 1) % 3] * v[(i + 2) % 3];
    for (Word& w : v) w ^= w >> 16;
  }
  return v;
}

Word reversed(Word x) {
  Word result = 0;
  for (int bit = 0; bit < 32; ++bit) result |= (x >> bit & 1u) << (31 - bit);
  return result;
}

// A dimension of Sobol's sequence: the direction numbers of the number's bits, added mod 2.
template <class Next>
Word sobol(Word number, Next next) {
  Word sum = 0;
  for (Word direction = 1u << 31; number != 0; number >>= 1, direction = next(direction)) {
    if (number & 1u) sum ^= direction;
  }
  return sum;
}

// Owen scrambling; x -> x ^ x k with k even, and x -> x k with k odd, let a bit of reversed(x)
// depend on itself and on lower ones only.
Word scrambled(Word x, Word seed) {
  x = reversed(x);
  x ^= x * 0x3d20adeau;
  x = (x + seed) * ((seed >> 16) | 1u);
  for (const Word k : {0x05526c56u, 0x53a22864u}) x ^= x * k;
  return reversed(x);
}

struct Place {
  Word x, y;  // in the pixel, in 2^-32
};

Place sobolPlace(const Hash& pixel, Word sample) {
  return {scrambled(sobol(sample, [](Word v) { return v >> 1; }), pixel[0]),
          scrambled(sobol(sample, [](Word v) { return v ^ v >> 1; }), pixel[1])};
}

// `random` of 2^32 in stratum `index` of `count`, each floor(2^32 / count) wide.
Word inStratum(std::uint64_t index, std::uint64_t count, std::uint64_t random) {
  const std::uint64_t width = (std::uint64_t{1} << 32) / count;
  return static_cast<Word>(index * width + (random * width >> 32));
}

Place stratifiedPlace(const Hash& pixel, std::uint64_t count, Word sample) {
  // The pair of factors that are nearest to each other.
  auto columns = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count)));
  while (count % columns != 0) --columns;
  const std::uint64_t rows = count / columns;
  const std::uint64_t first = count * pixel[2] >> 32;
  const std::uint64_t stratum = (first + sample) % count;
  const Hash random = hashOf(pixel[0], pixel[1], sample);
  return {inStratum(stratum / rows, columns, random[0]),
          inStratum(stratum % rows, rows, random[1])};
}

Word foldedSeed(const Sampler& sampler) {
  const auto seed = static_cast<std::uint64_t>(sampler.seed);
  return static_cast<Word>(seed) ^ static_cast<Word>(seed >> 32) * 0x9e3779b9u;
}

}  // namespace

glm::vec2 hashedAperture(const Sampler& sampler, int x, int y, std::uint32_t sample) {
  const Hash pixel = hashOf(static_cast<Word>(x), static_cast<Word>(y), ~foldedSeed(sampler));
  Place place{};
  if (sampler.row == &samplers::sobol) {
    place = sobolPlace(pixel, scrambled(sample, pixel[2]));
  } else {
    const Hash random = hashOf(pixel[0], pixel[1], sample);
    place = {random[0], random[1]};
  }
  const auto number = [](Word w) { return std::ldexp(static_cast<float>(w >> 9), -23); };
  return {number(place.x), number(place.y)};
}

glm::vec2 hashedPosition(const Camera& camera, const Sampler& sampler, int x, int y,
                         std::uint32_t sample) {
  const Hash pixel = hashOf(static_cast<Word>(x), static_cast<Word>(y), foldedSeed(sampler));
  const Place place = sampler.row == &samplers::sobol
                          ? sobolPlace(pixel, sample)
                          : stratifiedPlace(pixel, sampler.sampleCount, sample);
  // A float has 24 bits; those that the largest pixel number leaves, 23 at most, hold the middle of
  // a cell, and all but the last of them the cell.
  int bits = 24;
  for (int largest = std::max(camera.width, camera.height) - 1; largest != 0; largest /= 2) --bits;
  bits = std::clamp(bits, 1, 23);
  const auto middle = [&](Word position) {
    const double cells = std::ldexp(1.0, bits - 1);
    return (std::floor(position * std::ldexp(1.0, -32) * cells) + 0.5) / cells;
  };
  return {static_cast<float>(x + middle(place.x)), static_cast<float>(y + middle(place.y))};
}

}  // namespace laver::reference
