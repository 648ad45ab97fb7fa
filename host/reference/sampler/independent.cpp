#include <algorithm>

#include "reference/hashed_sampler.h"
#include "reference/pcg32.h"
#include "reference/sampler.h"

/// Nori's sampler: every block of 32 x 32 pixels of the full film, clipped at the border, has its
/// own PCG32, with state x + seed and sequence y + seed for a first pixel (x, y). It draws four
/// numbers per sample: y and x of the film position, then of the aperture. Further dimensions are
/// hashed.
namespace laver::reference::independent {

namespace {

constexpr int blockSize = 32;            // pixels
constexpr std::uint64_t dimensions = 4;  // numbers per sample

Pcg32 generatorAt(const Camera& camera, const Sampler& sampler, const PixelSample& at) {
  const int blockX = at.x / blockSize * blockSize;
  const int blockY = at.y / blockSize * blockSize;
  const int blockWidth = std::min(blockSize, camera.width - blockX);
  const auto seed = static_cast<std::uint64_t>(sampler.seed);
  Pcg32 random(static_cast<std::uint64_t>(blockX) + seed,
               static_cast<std::uint64_t>(blockY) + seed);
  const int pixel = (at.y - blockY) * blockWidth + (at.x - blockX);
  random.advance(dimensions *
                 (static_cast<std::uint64_t>(pixel) * sampler.sampleCount + at.sample));
  return random;
}

}  // namespace

// The sum is rounded to float, and may be the next pixel's edge.
glm::vec2 position(const Camera& camera, const Sampler& sampler, const PixelSample& at) {
  Pcg32 random = generatorAt(camera, sampler, at);
  const float jitterY = random.nextFloat();
  const float jitterX = random.nextFloat();
  return {static_cast<float>(at.x) + jitterX, static_cast<float>(at.y) + jitterY};
}

glm::vec2 pair(const Camera& camera, const Sampler& sampler, const PixelSample& at,
               std::uint32_t dimension) {
  if (dimension >= 2) return hashed::randomPair(sampler, at, dimension);
  Pcg32 random = generatorAt(camera, sampler, at);
  random.advance(2);
  const float v = random.nextFloat();
  const float u = random.nextFloat();
  return {u, v};
}

}  // namespace laver::reference::independent
