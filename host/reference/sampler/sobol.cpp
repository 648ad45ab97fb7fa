#include "reference/hashed_sampler.h"
#include "reference/sampler.h"

/// Sobol's first two dimensions, each Owen-scrambled by a hash of the pixel. Each further pair of
/// dimensions is the same sequence, scrambled by another hash, in an order given by Owen scrambling
/// of the sample's number (Burley, JCGT 9(4), 2020, section 5).
namespace laver::reference::sobol {

namespace {

using hashed::Hash;
using hashed::Word;

Word reversed(Word x) {
  Word result = 0;
  for (int bit = 0; bit < 32; ++bit) result |= (x >> bit & 1u) << (31 - bit);
  return result;
}

// One dimension of Sobol's sequence: the sum mod 2 of the direction numbers for the bits of
// `number`.
template <class Next>
Word sequence(Word number, Next next) {
  Word sum = 0;
  for (Word direction = 1u << 31; number != 0; number >>= 1, direction = next(direction)) {
    if (number & 1u) sum ^= direction;
  }
  return sum;
}

// Owen scrambling. In x -> x ^ x k with even k and x -> x k with odd k, a bit of reversed(x)
// depends only on itself and lower bits.
Word scrambled(Word x, Word seed) {
  x = reversed(x);
  x ^= x * 0x3d20adeau;
  x = (x + seed) * ((seed >> 16) | 1u);
  for (const Word k : {0x05526c56u, 0x53a22864u}) x ^= x * k;
  return reversed(x);
}

hashed::Place placeOf(const Hash& pixel, Word sample) {
  return {scrambled(sequence(sample, [](Word v) { return v >> 1; }), pixel[0]),
          scrambled(sequence(sample, [](Word v) { return v ^ v >> 1; }), pixel[1])};
}

}  // namespace

glm::vec2 position(const Camera& camera, const Sampler& sampler, const PixelSample& at) {
  const Hash pixel = hashed::pixelHash(at, hashed::foldedSeed(sampler));
  return hashed::filmPosition(camera, at, placeOf(pixel, at.sample));
}

glm::vec2 pair(const Camera&, const Sampler& sampler, const PixelSample& at,
               std::uint32_t dimension) {
  const Hash pixel = hashed::pixelHash(
      at, ~hashed::foldedSeed(sampler) ^ ((dimension - 1) * hashed::kDimensionStep));
  return hashed::unitPair(placeOf(pixel, scrambled(at.sample, pixel[2])));
}

}  // namespace laver::reference::sobol
