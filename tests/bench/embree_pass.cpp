#include "bench/embree_pass.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "bench/embree_chunk.h"
#include "core/error.h"

namespace laver::bench {
namespace {

/// Past the caches: nothing reads it soon, and lines need not be fetched to be overwritten.
template <class T>
void store(const T& from, T& to) {
  const auto* const in = reinterpret_cast<const float*>(&from);
  auto* const out = reinterpret_cast<float*>(&to);
  for (std::size_t i = 0; i < sizeof(T) / sizeof(float); i += 8)
    _mm256_stream_ps(out + i, _mm256_load_ps(in + i));
}

}  // namespace

EmbreePass::EmbreePass(const Packed& data, std::uint32_t samples, std::vector<glm::vec3> albedos)
    : params_(data.params),
      sampler_(data.constants[shared::SPEC_SAMPLER]),
      lights_(data.lights),
      albedos_(std::move(albedos)) {
  const auto width = params_.film.x, height = params_.film.y;
  if (width % kBlock != 0 || height % 4 != 0 || data.constants[shared::SPEC_NORMALS] != 0 ||
      (data.constants[shared::SPEC_ALBEDOS] != 0 && albedos_.empty()))
    throw Error(ExitCode::Scene,
                "Embree's side takes scenes without vertex normals and a film of whole 32 x 4 "
                "pixels");
  seed_ = params_.seed.x | std::uint64_t{params_.seed.y} << 32;
  // As host/render/sampler_data.cpp numbers Nori's stream: four numbers a sample, and one step
  // that ends the seeding.
  const std::uint64_t perPixel = 4 * std::uint64_t{params_.film.z};
  for (std::uint64_t i = 0; i < std::uint64_t{kBlock} * kBlock; ++i)
    pixels_.push_back(pcgJump(1 + perPixel * i));
  for (std::uint64_t i = 0; i < params_.film.z; ++i) samples_.push_back(pcgJump(4 * i));
  stored_.resize(std::size_t{width} * height * samples / 16);
}

EmbreePass::Result EmbreePass::run(const EmbreeCall& call, std::uint32_t first, std::uint32_t count,
                                   unsigned threads, bool clocked) {
  const int width = static_cast<int>(params_.film.x), height = static_cast<int>(params_.film.y);
  std::vector<Block> blocks;
  for (int y = 0; y < height; y += kBlock)
    for (int x = 0; x < width; x += kBlock) {
      const int rows = std::min(kBlock, height - y);
      blocks.push_back(
          {x, y, rows, static_cast<std::size_t>(y * width + x * rows) / 16 * count, first, count});
    }
  std::atomic<std::size_t> next{0};
  std::vector<Result> results(threads);
  const auto work = [&](Result& result) {
    const FlushDenormals flush;
    Chunk chunk(params_);
    Clock clock{clocked};
    const std::uint64_t start = __rdtsc();
    for (std::size_t i = next++; i < blocks.size(); i = next++)
      traceBlock(call, blocks[i], chunk, clock, result);
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

EmbreePass::Lanes EmbreePass::lanesOf(bool together, std::size_t sample) const {
  Lanes lanes;
  const std::uint64_t perPixel = 4 * std::uint64_t{params_.film.z};
  for (std::uint64_t i = 0; i < 16; ++i) {
    const std::uint64_t x = together ? 0 : i % 4, y = together ? 0 : i / 4;
    const PcgJump jump = together ? samples_[sample + i] : pcgJump(perPixel * (y * kBlock + x));
    lanes.x[i] = static_cast<std::uint32_t>(x);
    lanes.y[i] = static_cast<std::uint32_t>(y);
    lanes.number[i] = together ? static_cast<std::uint32_t>(sample + i) : 0;
    lanes.multiplier[i] = jump.multiplier;
    lanes.increments[i] = jump.increments;
  }
  return lanes;
}

void EmbreePass::trace(const EmbreeCall& call, Chunk& c, Clock& clock, Result& result) const {
  RTCIntersectContext context = contextOf(true);
  std::uint64_t since = clock.now();
  intersect(call.scene, call.width, context, c.all, c.rays);
  clock.add(since);
  int hits = 0;
  for (const unsigned id : c.rays.hit.geomID) hits += id != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
  result.hits += static_cast<std::uint64_t>(hits);
  if (lights_.empty()) {
    shadeDepth(c);
    return;
  }
  for (auto* channel : {&c.out.red, &c.out.green, &c.out.blue})
    std::fill(std::begin(*channel), std::end(*channel), 0.0F);
  for (const shared::Light& light : lights_) {
    const int shadows = aimAtLight(c, light);
    result.shadowRays += static_cast<std::uint64_t>(shadows);
    since = clock.now();
    if (shadows > 0) occluded(call.scene, call.width, context, c.live, c.shadow);
    clock.add(since);
    shadeLight(c, light);
  }
  if (!albedos_.empty()) applyAlbedos(c);
}

void EmbreePass::traceBlock(const EmbreeCall& call, Block block, Chunk& c, Clock& clock,
                            Result& result) {
  const Lanes lanes = lanesOf(call.together, block.first);
  for (int pixel = 0; pixel < block.rows * kBlock; pixel += call.together ? 1 : 16) {
    const glm::ivec2 at = placeInBlock(pixel);
    for (std::size_t s = block.first; s < block.first + block.count; s += call.together ? 16 : 1) {
      // Of samples together, the lanes jump from the first.
      generate(block, at.x, at.y, call.together ? 0 : s, lanes, c);
      trace(call, c, clock, result);
      store(c.out, stored_[block.slot++]);
    }
  }
}

void EmbreePass::addTo(std::vector<float>& image, const EmbreeCall& call,
                       std::uint32_t count) const {
  const int width = static_cast<int>(params_.film.x), height = static_cast<int>(params_.film.y);
  image.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  std::size_t slot = 0;
  for (int y = 0; y < height; y += kBlock)
    for (int x = 0; x < width; x += kBlock)
      for (int first = 0; first < std::min(kBlock, height - y) * kBlock; first += 16)
        for (int i = 0; i < 16 * static_cast<int>(count); ++i, ++slot) {
          const int lane = call.together ? i / static_cast<int>(count) : i % 16;
          const glm::ivec2 place = placeInBlock(first + lane);
          const auto at = static_cast<std::size_t>((y + place.y) * width + x + place.x) * 3;
          image[at] += stored_[slot / 16].red[slot % 16];
          image[at + 1] += stored_[slot / 16].green[slot % 16];
          image[at + 2] += stored_[slot / 16].blue[slot % 16];
        }
}

}  // namespace laver::bench
