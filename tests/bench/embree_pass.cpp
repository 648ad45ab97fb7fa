#include "bench/embree_pass.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "bench/embree_chunk.h"
#include "core/error.h"
#include "render/sampler_data.h"

namespace laver::bench {
namespace {

constexpr int kBlock = 32;

/// Past the caches where a pass is larger than they are.
template <class T>
void store(const T& from, T& to, bool past) {
  if (!past) {
    to = from;
    return;
  }
  const auto* const in = reinterpret_cast<const float*>(&from);
  auto* const out = reinterpret_cast<float*>(&to);
  for (std::size_t i = 0; i < sizeof(T) / sizeof(float); i += 8)
    _mm256_stream_ps(out + i, _mm256_load_ps(in + i));
}

}  // namespace

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
  stored_.resize(std::size_t{width} * height * samples / 16);
}

EmbreePass::Result EmbreePass::run(const EmbreeCall& call, std::uint32_t first, std::uint32_t count,
                                   unsigned threads, bool clocked) {
  const int width = static_cast<int>(params_.film.x), height = static_cast<int>(params_.film.y);
  std::vector<Block> blocks;
  for (int y = 0; y < height; y += kBlock)
    for (int x = 0; x < width; x += kBlock) {
      const int rows = std::min(kBlock, height - y);
      blocks.push_back({x, y, static_cast<std::size_t>(rows * kBlock),
                        static_cast<std::size_t>(y * width + x * rows) / 16 * count, first, count});
    }
  std::atomic<std::size_t> next{0};
  std::vector<Result> results(threads);
  const auto work = [&](Result& result) {
    const FlushDenormals flush;
    const auto chunk = std::make_unique<Chunk>(params_);
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
      store(c.out, stored_[block.slot++], block.count > 1);
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
          image[at] += stored_[slot / 16].red[slot % 16];
          image[at + 1] += stored_[slot / 16].green[slot % 16];
          image[at + 2] += stored_[slot / 16].blue[slot % 16];
        }
}

}  // namespace laver::bench
