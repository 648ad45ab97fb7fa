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

/// PCG32's output (O'Neill 2014, XSH-RR).
std::uint32_t outputOf(std::uint64_t state) {
  const auto word = static_cast<std::uint32_t>(((state >> 18) ^ state) >> 27);
  const auto rotation = static_cast<std::uint32_t>(state >> 59);
  return word >> rotation | word << (-rotation & 31U);
}

float unitFloat(std::uint32_t bits) { return std::bit_cast<float>(bits >> 9 | 0x3f800000U) - 1.0F; }

}  // namespace

void EmbreePass::placeIndependent(const Block& block, int x, int y, std::size_t sample,
                                  const Lanes& lanes, Chunk& c) const {
  const std::uint64_t sequence = seed_ + static_cast<std::uint64_t>(block.y);
  const std::uint64_t inc = sequence << 1 | 1U;
  const PcgJump byPixel =
      pixels_[static_cast<std::size_t>(y) * kBlock + static_cast<std::size_t>(x)];
  const PcgJump bySample = samples_[sample];
  std::uint64_t first = inc + seed_ + static_cast<std::uint64_t>(block.x);
  first = byPixel.multiplier * first + byPixel.increments * inc;
  first = bySample.multiplier * first + bySample.increments * inc;
  alignas(64) std::uint64_t state[16];
  for (int i = 0; i < 16; ++i) state[i] = lanes.multiplier[i] * first + lanes.increments[i] * inc;
  for (int i = 0; i < 16; ++i) {
    c.places.y[i] = outputOf(state[i]);
    c.places.x[i] = outputOf(state[i] * kMultiplier + inc);
  }
}

void EmbreePass::generate(const Block& block, int x, int y, std::size_t sample, const Lanes& lanes,
                          Chunk& c) const {
  for (int i = 0; i < 16; ++i) {
    c.places.pixelX[i] = static_cast<std::uint32_t>(block.x + x) + lanes.x[i];
    c.places.pixelY[i] = static_cast<std::uint32_t>(block.y + y) + lanes.y[i];
    c.places.number[i] = static_cast<std::uint32_t>(sample) + lanes.number[i];
  }
  if (sampler_ == shared::SAMPLER_SOBOL)
    placeSobol(params_, c.places);
  else if (sampler_ == shared::SAMPLER_STRATIFIED)
    placeStratified(params_, c.places);
  else
    placeIndependent(block, x, y, sample, lanes, c);
  RTCRay16& ray = c.rays.ray;
  const auto w = static_cast<float>(params_.film.x), h = static_cast<float>(params_.film.y);
  const glm::vec3 X = params_.columnX, Y = params_.columnY, Z = params_.columnZ;
  const float tmax = params_.clip.y;
  for (int i = 0; i < 16; ++i) {
    const auto px = static_cast<float>(static_cast<int>(c.places.pixelX[i]));
    const auto py = static_cast<float>(static_cast<int>(c.places.pixelY[i]));
    const float filmX = px + unitFloat(c.places.x[i]);
    const float filmY = py + unitFloat(c.places.y[i]);
    c.out.x[i] = filmX - px;
    c.out.y[i] = filmY - py;
    const float u = w - 2.0F * filmX, v = h - 2.0F * filmY;
    ray.dir_x[i] = X.x * u + Y.x * v + Z.x;
    ray.dir_y[i] = X.y * u + Y.y * v + Z.y;
    ray.dir_z[i] = X.z * u + Y.z * v + Z.z;
    ray.tfar[i] = tmax;
    c.rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
}

void EmbreePass::shadeDepth(Chunk& c) const {
  const RTCRay16& ray = c.rays.ray;
  for (int i = 0; i < 16; ++i) {
    const float length = std::sqrt(ray.dir_x[i] * ray.dir_x[i] + ray.dir_y[i] * ray.dir_y[i] +
                                   ray.dir_z[i] * ray.dir_z[i]);
    const float depth = 1.0F / (ray.tfar[i] * length * params_.clip.z);
    c.out.red[i] = c.rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? depth : 0.0F;
    c.out.green[i] = c.out.red[i];
    c.out.blue[i] = c.out.red[i];
  }
}

int EmbreePass::aimAtLight(Chunk& c, const shared::Light& source) const {
  const RTCRay16& ray = c.rays.ray;
  const RTCHit16& hit = c.rays.hit;
  int shadows = 0;
  RTCRay16& to = c.shadow;
  const glm::vec3 light = source.position;
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
  return shadows;
}

void EmbreePass::shadeLight(Chunk& c, const shared::Light& light) const {
  const glm::vec3 albedo = albedos_.empty() ? glm::vec3(params_.albedo) : glm::vec3(1.0F);
  const glm::vec3 power = light.radiance * albedo;
  for (int i = 0; i < 16; ++i) {
    const float seen = c.shadow.tfar[i] >= 0.0F ? c.factor[i] : 0.0F;
    c.out.red[i] += power.x * seen;
    c.out.green[i] += power.y * seen;
    c.out.blue[i] += power.z * seen;
  }
}

void EmbreePass::applyAlbedos(Chunk& c) const {
  for (int i = 0; i < 16; ++i) {
    const bool hit = c.rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    const glm::vec3 albedo = albedos_[hit ? c.rays.hit.primID[i] : 0];
    c.out.red[i] *= albedo.x;
    c.out.green[i] *= albedo.y;
    c.out.blue[i] *= albedo.z;
  }
}

}  // namespace laver::bench
