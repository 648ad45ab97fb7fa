#include "bench/embree_pass.h"

#include <x86intrin.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <thread>

#include "bench/embree_packet.h"
#include "core/error.h"
#include "render/sampler_data.h"

namespace laver::bench {
namespace {

constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;
constexpr int kBlock = 32;
constexpr float kInvPi = 0.31830989F;
/// Of shadow rays along the normal, in the kernels' space of [-1, 1]^3: some 100 roundings of
/// origin + t * direction.
constexpr float kOffset = 1e-5F;

/// PCG32's output (O'Neill 2014, XSH-RR) as a float of [0, 1).
float unitFloat(std::uint64_t state) {
  const auto word = static_cast<std::uint32_t>(((state >> 18) ^ state) >> 27);
  const auto rotation = static_cast<std::uint32_t>(state >> 59);
  const std::uint32_t bits = word >> rotation | word << (-rotation & 31U);
  return std::bit_cast<float>(bits >> 9 | 0x3f800000U) - 1.0F;
}

}  // namespace

struct EmbreePass::Chunk {
  RTCRayHit16 rays{};
  RTCRay16 shadow{};
  alignas(64) float x[16], y[16], red[16], green[16], blue[16], factor[16];
  alignas(64) int all[16], live[16];
};

struct EmbreePass::Block {
  int x, y;
  std::size_t pixels;  ///< whole rows of 32
  std::size_t slot;    ///< of its first sample
  std::uint32_t first, count;
};

/// Cycles inside rtc calls, less those that reading the counter takes.
struct EmbreePass::Clock {
  bool on;
  std::uint64_t inside = 0, reads = 0;
  std::uint64_t now() const { return on ? __rdtsc() : 0; }
  void add(std::uint64_t since) {
    inside += now() - since;
    reads += on ? 1 : 0;
  }
};

EmbreePass::EmbreePass(const SceneData& data, std::uint32_t samples)
    : params_(data.params), shadows_(!data.lights.empty()) {
  const auto width = params_.film.x, height = params_.film.y;
  if (width % kBlock != 0 || height % 4 != 0 || data.lights.size() > 1 ||
      data.constants[shared::SPEC_NORMALS] != 0 || data.constants[shared::SPEC_ALBEDOS] != 0)
    throw Error(ExitCode::Scene,
                "the bench's scenes have one light, one albedo, no normals and a "
                "film of whole 32 x 4 pixels");
  if (shadows_) light_ = data.lights.front();
  seed_ = params_.seed.x | std::uint64_t{params_.seed.y} << 32;
  // As host/render/sampler_data.cpp numbers Nori's stream: four numbers a sample, and one step
  // that ends the seeding.
  const std::uint64_t perPixel = 4 * std::uint64_t{params_.film.z};
  for (int i = 0; i < kBlock * kBlock; ++i) {
    const int tile = i / 16, x = tile % 8 * 4 + i % 4, y = tile / 8 * 4 + i / 4 % 4;
    const PcgJump jump = pcgJump(1 + perPixel * static_cast<std::uint64_t>(y * kBlock + x));
    pixelX_.push_back(static_cast<float>(x));
    pixelY_.push_back(static_cast<float>(y));
    pixelMultiplier_.push_back(jump.multiplier);
    pixelIncrements_.push_back(jump.increments);
  }
  for (std::uint32_t s = 0; s < params_.film.z; ++s) {
    sampleMultiplier_.push_back(pcgJump(4 * std::uint64_t{s}).multiplier);
    sampleIncrements_.push_back(pcgJump(4 * std::uint64_t{s}).increments);
  }
  for (auto* values : {&red_, &green_, &blue_, &insideX_, &insideY_})
    values->resize(std::size_t{width} * height * samples);
}

EmbreePass::Result EmbreePass::run(const EmbreeCall& call, std::uint32_t first, std::uint32_t count,
                                   unsigned threads, bool clocked) {
  const int width = static_cast<int>(params_.film.x), height = static_cast<int>(params_.film.y);
  std::vector<Block> blocks;
  for (int y = 0; y < height; y += kBlock)
    for (int x = 0; x < width; x += kBlock) {
      const int rows = std::min(kBlock, height - y);
      blocks.push_back({x, y, static_cast<std::size_t>(rows * kBlock),
                        static_cast<std::size_t>(y * width + x * rows) * count, first, count});
    }
  std::atomic<std::size_t> next{0};
  std::vector<Result> results(threads);
  const auto work = [&](Result& result) {
    flushDenormals();
    auto chunk = std::make_unique<Chunk>();
    std::fill_n(chunk->all, 16, -1);
    Clock clock{clocked};
    const std::uint64_t start = __rdtsc();
    for (std::size_t i = next++; i < blocks.size(); i = next++)
      traceBlock(call, blocks[i], *chunk, clock, result);
    auto total = static_cast<double>(__rdtsc() - start);
    std::uint64_t read = ~0ULL;  // what one pair of readings takes
    for (int i = 0; i < 1000; ++i) {
      const std::uint64_t begin = __rdtsc();
      read = std::min<std::uint64_t>(read, __rdtsc() - begin);
    }
    const auto reading = static_cast<double>(read * clock.reads);
    total -= 2.0 * reading;
    result.outside = 1.0 - (static_cast<double>(clock.inside) - reading) / total;
  };
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads; ++t) others.emplace_back([&, t] { work(results[t]); });
  work(results[0]);
  for (std::thread& other : others) other.join();
  Result sum;
  sum.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const Result& result : results) {
    sum.outside += result.outside / threads;
    sum.hits += result.hits;
    sum.shadowRays += result.shadowRays;
  }
  return sum;
}

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
  const glm::vec3 origin = params_.origin;
  const float tmin = params_.clip.x, tmax = params_.clip.y;
  for (int i = 0; i < 16; ++i) {
    const float filmY = py[i] + unitFloat(state[i]);
    const float filmX = px[i] + unitFloat(state[i] * kMultiplier + inc);
    c.x[i] = filmX - px[i];
    c.y[i] = filmY - py[i];
    const float x = w - 2.0F * filmX, y = h - 2.0F * filmY;
    ray.dir_x[i] = X.x * x + Y.x * y + Z.x;
    ray.dir_y[i] = X.y * x + Y.y * y + Z.y;
    ray.dir_z[i] = X.z * x + Y.z * y + Z.z;
    ray.org_x[i] = origin.x;
    ray.org_y[i] = origin.y;
    ray.org_z[i] = origin.z;
    ray.tnear[i] = tmin;
    ray.tfar[i] = tmax;
    ray.time[i] = 0.0F;
    ray.mask[i] = ~0U;
    ray.flags[i] = 0;
    c.rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    c.rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
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
      c.red[i] = hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? depth : 0.0F;
      c.green[i] = c.red[i];
      c.blue[i] = c.red[i];
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
    to.tnear[i] = 0.0F;
    // Where Embree has no packets of 16 it goes by this, not by the mask.
    to.tfar[i] = live ? 1.0F : -1.0F;
    to.time[i] = 0.0F;
    to.mask[i] = ~0U;
    to.flags[i] = 0;
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
    c.red[i] = power.x * seen;
    c.green[i] = power.y * seen;
    c.blue[i] = power.z * seen;
  }
}

void EmbreePass::traceBlock(const EmbreeCall& call, Block block, Chunk& c, Clock& clock,
                            Result& result) {
  const std::size_t pixels = call.together ? 1 : 16, samples = call.together ? 16 : 1;
  for (std::size_t pixel = 0; pixel < block.pixels; pixel += pixels) {
    for (std::size_t s = 0; s < block.count; s += samples) {
      generate(block, pixel, block.first + static_cast<std::uint32_t>(s), call.together, c);
      RTCIntersectContext context = contextOf(true);
      const std::uint64_t since = clock.now();
      intersect(call.scene, call.width, context, c.all, c.rays);
      clock.add(since);
      shade(call, c, clock, result);
      std::memcpy(&red_[block.slot], c.red, sizeof c.red);
      std::memcpy(&green_[block.slot], c.green, sizeof c.green);
      std::memcpy(&blue_[block.slot], c.blue, sizeof c.blue);
      std::memcpy(&insideX_[block.slot], c.x, sizeof c.x);
      std::memcpy(&insideY_[block.slot], c.y, sizeof c.y);
      block.slot += 16;
    }
  }
}

void EmbreePass::addTo(std::vector<float>& image, const EmbreeCall& call,
                       std::uint32_t count) const {
  const std::size_t width = params_.film.x, height = params_.film.y;
  image.resize(width * height * 3);
  std::size_t slot = 0;
  for (std::size_t y = 0; y < height; y += kBlock)
    for (std::size_t x = 0; x < width; x += kBlock)
      for (std::size_t first = 0; first < std::min<std::size_t>(kBlock, height - y) * kBlock;
           first += 16)
        for (std::size_t i = 0; i < std::size_t{16} * count; ++i, ++slot) {
          const std::size_t pixel = first + (call.together ? i / count : i % 16);
          const std::size_t at = ((y + static_cast<std::size_t>(pixelY_[pixel])) * width + x +
                                  static_cast<std::size_t>(pixelX_[pixel])) *
                                 3;
          image[at] += red_[slot];
          image[at + 1] += green_[slot];
          image[at + 2] += blue_[slot];
        }
}

}  // namespace laver::bench
