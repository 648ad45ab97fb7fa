#pragma once
#include <span>

#include "image/bitmap.h"

namespace laver {

/// A logarithmic scale from 10^low to 10^high.
struct LogScale {
  int low = -8;
  int high = 0;
};

/// From 10^-8 to 1, so that most images have the same scale; the upper end is the next power of ten
/// if a finite distance is larger than 1.
LogScale scaleFor(std::span<const double> distances);

/// Black for 0, magenta for a value that is not finite, else a colour of matplotlib's viridis, from
/// dark violet over green to yellow as the distance grows; clamped to the ends of the scale.
Rgb8 falseColour(double distance, LogScale scale);

/// `distances` of width * height pixels in false colours, with a labelled scale on the right. The
/// image begins at (0, 0); the bitmap is wider than the image, and higher than a low one.
Bitmap drawDistances(std::span<const double> distances, int width, int height);

}  // namespace laver
