#pragma once
#include <cstdint>
#include <string>

#include "image/image.h"
#include "lab/explain/bounds.h"
#include "lab/explain/judge.h"
#include "random/generator.h"
#include "reference/reference.h"

namespace laver::test {

/// Pixels of a picture that differ from the reference's of the same samples.
struct Compared {
  int differing = 0;    ///< beyond kTolerance
  int unexplained = 0;  ///< those for which no bound of rounding accounts
  int pixels = 0;
  double drift = 0;   ///< mean of the differences in units of its standard error
  std::string first;  ///< the first unexplained pixel
};

/// Relative to the pixel, or to the median of those that are not black. Most samples agree to 1e-5;
/// the bounds of the rest are large only where rounding shows.
inline constexpr double kTolerance = 1e-3;

/// Least median of radiance: lights are such that white surfaces have about 1. Light that comes
/// from within a surface's own plane has a cosine that is rounding, and would be all that there is.
inline constexpr double kLeastLevel = 1e-2;

Compared compare(const Image& image, const Image& truth, const RandomScene& random,
                 const Reference& reference);

}  // namespace laver::test
