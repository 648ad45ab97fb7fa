#pragma once
#include <functional>
#include <string>
#include <vector>

#include "image/image.h"
#include "lab/chart/kept.h"
#include "scene/scene.h"

namespace laver::chart {

/// What a converged picture must know of itself.
struct Truth {
  Image image;
  double band = 0;          ///< its own RMSE, estimated: half that between its two halves
  double relativeBand = 0;  ///< its own relative MSE: a quarter of that between them
};

/// The smallest square number that is no less.
std::uint32_t squareFrom(std::uint32_t samples);

/// How the truth is made.
struct TruthOptions {
  std::uint32_t samples = 1024;  ///< a pixel and half; a square number, or the next one is taken
  unsigned threads = 0;
  std::function<bool()> stop;            ///< true ends it; what there is is kept
  std::function<void(double)> progress;  ///< share done
};

/// The scene by each of the filters in double precision, from stratified samples: the mean of two
/// halves of different seeds, whose difference tells how far it may be off. What is in `kept` under
/// a key that begins with `key` is taken, and work that was stopped is gone on with. Empty where
/// options.stop ended it.
std::vector<Truth> truthOf(const Scene& scene, std::span<const Filter> filters,
                           const TruthOptions& options, const Kept& kept, const std::string& key);

}  // namespace laver::chart
