#pragma once
#include <span>

#include "image/bitmap.h"

namespace laver {

/// A logarithmic scale from 10^low to 10^high.
struct LogScale {
  int low = -8;
  int high = 0;
};

/// From 10^-8 to 1, the same for most pictures so that they can be set side by side; further up,
/// to a power of ten, where a finite distance is larger.
LogScale scaleFor(std::span<const double> distances);

/// Black for 0, magenta for what is not finite, else a colour from dark violet over green to yellow
/// (matplotlib's viridis) that is the brighter the larger the distance; beyond the scale its end.
Rgb8 falseColour(double distance, LogScale scale);

/// `distances` of width * height pixels in false colours, with the scale beside them on the right
/// and its numbers, "0" and "inf" below it. The picture is at (0, 0); it is wider, and a low one
/// higher, than what it shows.
Bitmap drawDistances(std::span<const double> distances, int width, int height);

}  // namespace laver
