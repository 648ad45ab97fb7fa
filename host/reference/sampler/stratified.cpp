#include <cmath>

#include "reference/hashed_sampler.h"
#include "reference/sampler.h"

/// Strata of equal size, column by column, starting at a stratum chosen by the pixel's hash; in
/// each a position hashed from the pixel and the sample's number. The other dimensions are hashed.
namespace laver::reference::stratified {

namespace {

using hashed::Hash;
using hashed::Word;

// The position `random` / 2^32 within stratum `index` of `count`, each floor(2^32 / count) wide.
Word inStratum(std::uint64_t index, std::uint64_t count, std::uint64_t random) {
  const std::uint64_t width = (std::uint64_t{1} << 32) / count;
  return static_cast<Word>(index * width + (random * width >> 32));
}

}  // namespace

glm::vec2 position(const Camera& camera, const Sampler& sampler, const PixelSample& at) {
  const Hash pixel = hashed::pixelHash(at, hashed::foldedSeed(sampler));
  // The factors of the count that are closest to each other.
  const std::uint64_t count = sampler.sampleCount;
  auto columns = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count)));
  while (count % columns != 0) --columns;
  const std::uint64_t rows = count / columns;
  const std::uint64_t first = count * pixel[2] >> 32;
  const std::uint64_t stratum = (first + at.sample) % count;
  const Hash random = hashed::hashOf(pixel[0], pixel[1], at.sample);
  return hashed::filmPosition(
      camera, at,
      {inStratum(stratum / rows, columns, random[0]), inStratum(stratum % rows, rows, random[1])});
}

glm::vec2 pair(const Camera&, const Sampler& sampler, const PixelSample& at,
               std::uint32_t dimension) {
  if (dimension >= 2) return hashed::randomPair(sampler, at, dimension);
  const Hash pixel = hashed::pixelHash(at, ~hashed::foldedSeed(sampler));
  const Hash random = hashed::hashOf(pixel[0], pixel[1], at.sample);
  return hashed::unitPair({random[0], random[1]});
}

}  // namespace laver::reference::stratified
