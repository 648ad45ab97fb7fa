#pragma once
#include <embree3/rtcore.h>

#include <vector>

#include "render/sampler_data.h"

namespace laver::bench {

class EmbreeFilm;

/// How Embree is called.
struct EmbreeCall {
  RTCScene scene;
  int width = 16;         ///< rays a call: 1, 8 or 16; 0: no calls, nothing is hit
  bool together = false;  ///< packets hold samples of one pixel instead of one of 4 x 4 pixels
};

/// A whole pass on Embree's side: the same samples as laver's, camera rays, nearest hits, and
/// either depth or direct light with a shadow ray, stored as r, g, b and the sample's place in its
/// pixel. All but the calls is written in loops of 16 that the compiler turns into vectors.
class EmbreePass {
 public:
  struct Result {
    double seconds = 0;
    double outside = 0;  ///< share of the threads' time outside rtc calls, where asked for
    std::uint64_t hits = 0, shadowRays = 0;
  };

  /// Of a scene packed for `depth` or `direct_whitted` without vertex normals and with a film of
  /// whole 32 x 4 pixels; where meshes differ in albedo, `albedos` has it of each triangle. At most
  /// `samples` a pixel in one pass. Throws Error.
  EmbreePass(const Packed& data, std::uint32_t samples, std::vector<glm::vec3> albedos = {});

  /// Samples [first, first + count) of each pixel. `clocked` reads a clock around each call.
  Result run(const EmbreeCall& call, std::uint32_t first, std::uint32_t count, unsigned threads,
             bool clocked = false);

  /// Adds the latest pass, of `count` samples, to rgb sums in rows of pixels.
  void addTo(std::vector<float>& image, const EmbreeCall& call, std::uint32_t count) const;

  /// Reconstructs the latest pass, of `count` samples, into a film.
  void addTo(EmbreeFilm& film, const EmbreeCall& call, std::uint32_t count, unsigned threads) const;

 private:
  /// What a pass leaves of 16 samples.
  struct alignas(64) Stored {
    float red[16], green[16], blue[16], x[16], y[16];
  };
  struct Chunk;
  struct Block;
  struct Lanes;
  struct Clock;
  void traceBlock(const EmbreeCall& call, Block block, Chunk& chunk, Clock& clock, Result& result);
  void placeIndependent(const Block& block, int x, int y, std::size_t sample, const Lanes& lanes,
                        Chunk& chunk) const;
  void generate(const Block& block, int x, int y, std::size_t sample, const Lanes& lanes,
                Chunk& chunk) const;
  Lanes lanesOf(bool together, std::size_t sample) const;
  void shadeDepth(Chunk& chunk) const;
  int aimAtLight(Chunk& chunk, const shared::Light& source) const;
  void shadeLight(Chunk& chunk, const shared::Light& light) const;
  void applyAlbedos(Chunk& chunk) const;
  void trace(const EmbreeCall& call, Chunk& chunk, Clock& clock, Result& result) const;

  shared::Params params_;
  std::uint32_t sampler_;
  std::vector<shared::Light> lights_;
  std::vector<glm::vec3> albedos_;  ///< empty: params_.albedo is that of all
  std::uint64_t seed_;
  // Jumps of the random stream from a 32 x 32 block's start, by pixel and by sample.
  std::vector<PcgJump> pixels_, samples_;
  std::vector<Stored> stored_;
};

}  // namespace laver::bench
