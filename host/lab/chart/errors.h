#pragma once
#include <cstdint>
#include <string>

#include "image/image.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace laver::chart {

/// How far a picture is from the truth, over all pixels and R, G, B.
struct Errors {
  double rmse = 0;
  double relativeMse = 0;  ///< as image/compare.h has it
};
Errors errorsOf(const Image& image, const Image& truth);

/// R, G and B of a picture. Throws Error(Usage) that names `file` where one of them is missing.
Image rgbOf(const Image& image, const std::string& file);

/// A picture beside the double-precision picture of the same samples.
struct Mismatches {
  std::uint64_t pixels = 0;       ///< that differ beyond kMismatch
  std::uint64_t unexplained = 0;  ///< of these, by Judge (explain/judge.h)
  double rmse = 0;                ///< over all pixels: what float arithmetic alone does
};

/// Beyond it a pixel is another value, relative to max(value, 1): float arithmetic over unit-sized
/// data keeps within some tens of ulp (6e-8), and this leaves room for grazing angles.
inline constexpr double kMismatch = 1e-4;

/// `truth` holds the samples of `scene`, `reference` is of that scene.
Mismatches mismatchesOf(const Image& image, const Image& truth, const Scene& scene,
                        const Reference& reference, unsigned threads);

}  // namespace laver::chart
