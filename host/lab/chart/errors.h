#pragma once
#include <cstdint>
#include <string>

#include "image/image.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace laver::chart {

/// Errors of a picture, over all pixels and R, G, B.
struct Errors {
  double rmse = 0;
  double relativeMse = 0;  ///< as in image/compare.h
};
Errors errorsOf(const Image& image, const Image& truth);

/// R, G and B of a picture. Throws Error(Usage) with the name `file` if one of them is missing.
Image rgbOf(const Image& image, const std::string& file);

/// A picture compared with the double-precision picture of the same samples.
struct Mismatches {
  std::uint64_t pixels = 0;       ///< that differ by more than kMismatch
  std::uint64_t unexplained = 0;  ///< those that Judge (explain/judge.h) does not explain
  double rmse = 0;                ///< over all pixels: the error of float arithmetic alone
};

/// Pixels match if they differ by at most this, relative to max(value, 1). Float arithmetic over
/// unit-sized data stays within some tens of ulp (6e-8); the rest is for grazing angles.
inline constexpr double kMismatch = 1e-4;

/// `truth` has the same samples as `image`; `scene` is the scene of both, and `reference` renders
/// it.
Mismatches mismatchesOf(const Image& image, const Image& truth, const Scene& scene,
                        const Reference& reference, unsigned threads);

}  // namespace laver::chart
