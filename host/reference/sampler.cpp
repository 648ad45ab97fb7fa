#include "reference/sampler.h"

#include <algorithm>

#include "reference/hashed_sampler.h"
#include "reference/pcg32.h"

namespace laver::reference {

namespace {

constexpr int blockSize = 32;            // pixels
constexpr std::uint64_t dimensions = 4;  // numbers a sample

Pcg32 generatorAt(const Camera& camera, const Sampler& sampler, int x, int y,
                  std::uint32_t sample) {
  const int blockX = x / blockSize * blockSize;
  const int blockY = y / blockSize * blockSize;
  const int blockWidth = std::min(blockSize, camera.width - blockX);
  const auto seed = static_cast<std::uint64_t>(sampler.seed);
  Pcg32 random(static_cast<std::uint64_t>(blockX) + seed,
               static_cast<std::uint64_t>(blockY) + seed);
  const int pixel = (y - blockY) * blockWidth + (x - blockX);
  random.advance(dimensions * (static_cast<std::uint64_t>(pixel) * sampler.sampleCount + sample));
  return random;
}

glm::vec2 independent(const Camera& camera, const Sampler& sampler, int x, int y,
                      std::uint32_t sample) {
  Pcg32 random = generatorAt(camera, sampler, x, y, sample);
  const float jitterY = random.nextFloat();
  const float jitterX = random.nextFloat();
  return {static_cast<float>(x) + jitterX, static_cast<float>(y) + jitterY};
}

}  // namespace

glm::vec2 samplePosition(const Camera& camera, const Sampler& sampler, int x, int y,
                         std::uint32_t sample) {
  if (sampler.row->stream) return independent(camera, sampler, x, y, sample);
  return hashedPosition(camera, sampler, x, y, sample);
}

glm::vec2 sampleAperture(const Camera& camera, const Sampler& sampler, int x, int y,
                         std::uint32_t sample) {
  if (!sampler.row->stream) return hashedAperture(sampler, x, y, sample);
  Pcg32 random = generatorAt(camera, sampler, x, y, sample);
  random.advance(2);
  const float v = random.nextFloat();
  const float u = random.nextFloat();
  return {u, v};
}

}  // namespace laver::reference
