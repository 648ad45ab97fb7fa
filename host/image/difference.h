#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

/// |a - b|; 0 for alike that are not finite (NaN and NaN, an infinity and its like), infinite for
/// unlike.
double distance(double a, double b);

/// Throws Error(Usage) unless both are pictures of one size with the same channels in any order.
void requireAlike(const Image& a, const Image& b);

/// The place in b's channels of each of a's.
std::vector<std::size_t> matchingChannels(const Image& a, const Image& b);

/// a - b with a's channels; 0 for alike that are not finite. Throws as requireAlike.
Image difference(const Image& a, const Image& b);

/// The largest distance over the channels, pixel by pixel. Throws as requireAlike.
std::vector<double> largestDistances(const Image& a, const Image& b);

}  // namespace laver
