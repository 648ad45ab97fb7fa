#pragma once
#include <x86intrin.h>

#include "bench/embree_packet.h"
#include "bench/embree_pass.h"
#include "bench/embree_sampler.h"

namespace laver::bench {

inline constexpr int kBlock = 32;

/// Pixel i of a block that is walked 4 x 4 pixels at a time.
inline glm::ivec2 placeInBlock(int i) {
  return {i / 16 % 8 * 4 + i % 4, i / 16 / 8 * 4 + i / 4 % 4};
}

/// Embree leaves alone what all rays have in common.
struct EmbreePass::Chunk {
  explicit Chunk(const shared::Params& params) {
    for (int i = 0; i < 16; ++i) {
      all[i] = -1;
      rays.ray.org_x[i] = params.origin.x;
      rays.ray.org_y[i] = params.origin.y;
      rays.ray.org_z[i] = params.origin.z;
      rays.ray.tnear[i] = params.clip.x;
      rays.ray.mask[i] = shadow.mask[i] = ~0U;
      rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
  }
  RTCRayHit16 rays{};
  RTCRay16 shadow{};
  Stored out;
  Places places;
  alignas(64) float factor[16];
  alignas(64) int all[16], live[16];
};

struct EmbreePass::Block {
  int x, y, rows;
  std::size_t slot;  ///< of its first 16 samples
  std::uint32_t first, count;
};

/// How the lanes of a packet differ from its first pixel and sample: place, number, and jump of the
/// stream.
struct EmbreePass::Lanes {
  alignas(64) std::uint32_t x[16], y[16], number[16];
  alignas(64) std::uint64_t multiplier[16], increments[16];
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

}  // namespace laver::bench
