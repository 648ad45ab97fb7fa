#include <bit>
#include <cmath>

#include "bench/embree_chunk.h"

namespace laver::bench {
namespace {

constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;
constexpr float kInvPi = 0.31830989F;
/// Of shadow rays along the normal, in the kernels' space of [-1, 1]^3: some 20 roundings of
/// origin + t * direction.
constexpr float kOffset = 2e-6F;

/// PCG32's output (O'Neill 2014, XSH-RR) as a float of [0, 1).
float unitFloat(std::uint64_t state) {
  const auto word = static_cast<std::uint32_t>(((state >> 18) ^ state) >> 27);
  const auto rotation = static_cast<std::uint32_t>(state >> 59);
  const std::uint32_t bits = word >> rotation | word << (-rotation & 31U);
  return std::bit_cast<float>(bits >> 9 | 0x3f800000U) - 1.0F;
}

}  // namespace

void EmbreePass::generate(const Block& block, std::size_t first, std::uint32_t sample,
                          bool together, Chunk& c) const {
  const std::uint64_t sequence = seed_ + static_cast<std::uint64_t>(block.y);
  const std::uint64_t inc = sequence << 1 | 1U;
  const std::uint64_t begin = inc + seed_ + static_cast<std::uint64_t>(block.x);
  alignas(64) std::uint64_t state[16];
  alignas(64) float px[16], py[16];
  const float x0 = static_cast<float>(block.x), y0 = static_cast<float>(block.y);
  if (together) {
    const std::uint64_t pixel = pixelMultiplier_[first] * begin + pixelIncrements_[first] * inc;
    const std::uint64_t* const m = &sampleMultiplier_[sample];
    const std::uint64_t* const s = &sampleIncrements_[sample];
    for (int i = 0; i < 16; ++i) state[i] = m[i] * pixel + s[i] * inc;
    for (int i = 0; i < 16; ++i) px[i] = x0 + pixelX_[first];
    for (int i = 0; i < 16; ++i) py[i] = y0 + pixelY_[first];
  } else {
    const std::uint64_t* const m = &pixelMultiplier_[first];
    const std::uint64_t* const s = &pixelIncrements_[first];
    const std::uint64_t byM = sampleMultiplier_[sample], byS = sampleIncrements_[sample] * inc;
    for (int i = 0; i < 16; ++i) state[i] = m[i] * begin + s[i] * inc;
    if (sample != 0)
      for (int i = 0; i < 16; ++i) state[i] = byM * state[i] + byS;
    const float* const x = &pixelX_[first];
    const float* const y = &pixelY_[first];
    for (int i = 0; i < 16; ++i) px[i] = x0 + x[i];
    for (int i = 0; i < 16; ++i) py[i] = y0 + y[i];
  }
  RTCRay16& ray = c.rays.ray;
  const float w = static_cast<float>(params_.film.x), h = static_cast<float>(params_.film.y);
  const glm::vec3 X = params_.columnX, Y = params_.columnY, Z = params_.columnZ;
  const float tmax = params_.clip.y;
  for (int i = 0; i < 16; ++i) {
    const float filmY = py[i] + unitFloat(state[i]);
    const float filmX = px[i] + unitFloat(state[i] * kMultiplier + inc);
    c.out.x[i] = filmX - px[i];
    c.out.y[i] = filmY - py[i];
    const float x = w - 2.0F * filmX, y = h - 2.0F * filmY;
    ray.dir_x[i] = X.x * x + Y.x * y + Z.x;
    ray.dir_y[i] = X.y * x + Y.y * y + Z.y;
    ray.dir_z[i] = X.z * x + Y.z * y + Z.z;
    ray.tfar[i] = tmax;
    c.rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
}

void EmbreePass::shade(const EmbreeCall& call, Chunk& c, Clock& clock, Result& result) const {
  const RTCRay16& ray = c.rays.ray;
  const RTCHit16& hit = c.rays.hit;
  int hits = 0, shadows = 0;
  for (int i = 0; i < 16; ++i) hits += hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
  result.hits += static_cast<std::uint64_t>(hits);
  if (!shadows_) {
    for (int i = 0; i < 16; ++i) {
      const float length = std::sqrt(ray.dir_x[i] * ray.dir_x[i] + ray.dir_y[i] * ray.dir_y[i] +
                                     ray.dir_z[i] * ray.dir_z[i]);
      const float depth = 1.0F / (ray.tfar[i] * length * params_.clip.z);
      c.out.red[i] = hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? depth : 0.0F;
      c.out.green[i] = c.out.red[i];
      c.out.blue[i] = c.out.red[i];
    }
    return;
  }
  RTCRay16& to = c.shadow;
  const glm::vec3 light = light_.position;
  for (int i = 0; i < 16; ++i) {
    const float nx = hit.Ng_x[i], ny = hit.Ng_y[i], nz = hit.Ng_z[i];
    const float n = 1.0F / std::sqrt(nx * nx + ny * ny + nz * nz);
    const float x = ray.org_x[i] + ray.tfar[i] * ray.dir_x[i];
    const float y = ray.org_y[i] + ray.tfar[i] * ray.dir_y[i];
    const float z = ray.org_z[i] + ray.tfar[i] * ray.dir_z[i];
    const float lx = light.x - x, ly = light.y - y, lz = light.z - z;
    const float squared = lx * lx + ly * ly + lz * lz;
    const float along = (nx * lx + ny * ly + nz * lz) * n;
    const float facing = nx * ray.dir_x[i] + ny * ray.dir_y[i] + nz * ray.dir_z[i];
    const bool live = (hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) & (along > 0.0F) & (facing < 0.0F);
    c.live[i] = live ? -1 : 0;
    shadows += live ? 1 : 0;
    c.factor[i] = live ? along / (std::sqrt(squared) * squared) * kInvPi : 0.0F;
    const float offset = n * kOffset;
    to.org_x[i] = x + nx * offset;
    to.org_y[i] = y + ny * offset;
    to.org_z[i] = z + nz * offset;
    to.dir_x[i] = light.x - to.org_x[i];
    to.dir_y[i] = light.y - to.org_y[i];
    to.dir_z[i] = light.z - to.org_z[i];
    // Where Embree has no packets of 16 it goes by this, not by the mask.
    to.tfar[i] = live ? 1.0F : -1.0F;
  }
  result.shadowRays += static_cast<std::uint64_t>(shadows);
  if (shadows > 0) {
    RTCIntersectContext context = contextOf(true);
    const std::uint64_t since = clock.now();
    occluded(call.scene, call.width, context, c.live, to);
    clock.add(since);
  }
  const glm::vec3 power = glm::vec3(light_.radiance) * glm::vec3(params_.albedo);
  for (int i = 0; i < 16; ++i) {
    const float seen = to.tfar[i] >= 0.0F ? c.factor[i] : 0.0F;
    c.out.red[i] = power.x * seen;
    c.out.green[i] = power.y * seen;
    c.out.blue[i] = power.z * seen;
  }
}

}  // namespace laver::bench
